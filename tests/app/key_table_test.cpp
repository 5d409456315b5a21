#include "app/key_table.h"

#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace bodkin::app {
namespace {

TEST(KeyTable, no_key_means_two_things_in_one_chain) {
  for (const KeyScope scope :
       {KeyScope::window, KeyScope::start, KeyScope::practise, KeyScope::view3d, KeyScope::slice, KeyScope::chart,
        KeyScope::plan, KeyScope::scan, KeyScope::review, KeyScope::models, KeyScope::devices, KeyScope::atlas,
        KeyScope::volume, KeyScope::ultrasound, KeyScope::segment, KeyScope::training, KeyScope::camera}) {
    std::map<std::string, int> count;
    for (const KeyScope each : chain_of(scope)) {
      for (const KeyBinding& binding : key_table()) {
        if (binding.scope == each) ++count[QKeySequence(QLatin1String(binding.keys)).toString().toStdString()];
      }
    }
    for (const auto& [keys, times] : count) EXPECT_EQ(times, 1) << keys << " in " << name_of(scope).toStdString();
  }
}

TEST(KeyTable, every_key_can_be_pressed) {
  for (const KeyBinding& binding : key_table()) {
    const QKeySequence keys{QLatin1String(binding.keys)};
    EXPECT_EQ(keys.count(), 1) << binding.keys;
    EXPECT_NE(keys[0] & ~static_cast<int>(Qt::KeyboardModifierMask), Qt::Key_unknown) << binding.keys;
    EXPECT_FALSE(text_of(binding).isEmpty()) << binding.keys;
  }
}

TEST(KeyTable, only_keys_of_window_needle_plan_and_review_are_reserved) {
  const std::set<KeyScope> allowed = {KeyScope::window, KeyScope::practise, KeyScope::plan, KeyScope::review};
  for (const KeyBinding& binding : key_table()) {
    if (!binding.reserved) continue;
    EXPECT_TRUE(allowed.contains(binding.scope)) << binding.keys;
  }
  EXPECT_EQ(reserved_command(KeyScope::practise, QKeySequence(QStringLiteral("Space"))), Command::hold);
  EXPECT_EQ(reserved_command(KeyScope::start, QKeySequence(QStringLiteral("Space"))), std::nullopt);
  EXPECT_EQ(reserved_command(KeyScope::start, QKeySequence(QStringLiteral("F1"))), Command::show_keys);
  EXPECT_EQ(command_of(KeyScope::slice, QKeySequence(QStringLiteral("M"))), Command::of_the_view);
}

}  // namespace
}  // namespace bodkin::app
