#include "training/expert_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/resources.h"
#include "training/procedure_file.h"

namespace bodkin {

using namespace bodkin::training;
namespace {

using ::testing::HasSubstr;

TEST(ExpertSet, places_a_value_by_percentile_and_by_standard_deviations) {
  const ExpertSet set = ExpertSet::parse(
      "# five "
      "experts\nattempt,verdict,path_length_mm,insertions\n1,pass,10,1\n2,pass,20,1\n3,pass,30,1\n4,pass,40,1\n"
      "5,pass,50,1\n",
      "experts.csv");
  EXPECT_EQ(set.size(), 5U);
  const auto middle = set.place("path_length_mm", 30.0);
  ASSERT_TRUE(middle.has_value());
  EXPECT_NEAR(middle->percentile, 50.0, 1e-12);
  EXPECT_NEAR(middle->z, 0.0, 1e-12);
  EXPECT_NEAR(middle->low, 12.0, 1e-12);
  EXPECT_NEAR(middle->high, 48.0, 1e-12);
  EXPECT_NEAR(set.place("path_length_mm", 45.0)->percentile, 80.0, 1e-12);
  EXPECT_NEAR(set.place("path_length_mm", 45.0)->z, 15.0 / std::sqrt(250.0), 1e-12);
  EXPECT_EQ(set.place("insertions", 3.0)->z, 0.0);  // all have the same value
  EXPECT_EQ(set.place("insertions", 3.0)->percentile, 100.0);
  EXPECT_FALSE(set.place("duration_s", 3.0).has_value());
}

TEST(ExpertSet, too_few_experts_are_no_comparison) {
  const ExpertSet set = ExpertSet::parse("insertions,bone_force_N\n1,\n1,\n1,2\n1,\n1,3\n", "e.csv");
  EXPECT_TRUE(set.place("insertions", 1.0).has_value());
  EXPECT_FALSE(set.place("bone_force_N", 1.0).has_value());
}

TEST(ExpertSet, refuses_what_is_no_table_of_attempts) {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      ExpertSet::parse(text, "e.csv");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal(""), HasSubstr("expected the names of metrics and at least one attempt"));
  EXPECT_THAT(refusal("insertions\nmany\n"), HasSubstr("e.csv, line 2: insertions is 'many', expected a number"));
  EXPECT_THAT(refusal("insertions,duration_s\n1\n"), HasSubstr("line 2: there are 1 fields, expected 2"));
  EXPECT_THAT(refusal("a,b\n1,2\n"), HasSubstr("no column is a metric"));
}

// Every rule of a procedure on what a hand does is compared with the experts shipped for it: none of them did harm,
// and nearly all passed.
TEST(ExpertSet, shipped_experts_have_what_their_procedure_asks_about_and_nearly_all_pass) {
  for (const std::string& name : shipped_procedures()) {
    if (name == "needle_insertion") continue;  // it has no goal of its own
    const auto experts = ExpertSet::shipped(name);
    ASSERT_TRUE(experts.has_value()) << name;
    EXPECT_EQ(experts->size(), 60U) << name;
    int kept = 0, rules = 0;
    for (const Rule& rule : find_procedure(name).rules) {
      const std::string_view metric = rule.metric;
      if (metric == "bone_force_N") continue;  // no expert met bone
      const bool is_guided = name.starts_with("ultrasound_guided");
      if (metric == "guide_steps_percent" && !is_guided) continue;  // no expert held a probe
      const auto place = experts->place(metric, 0.0);
      ASSERT_TRUE(place.has_value()) << name << ' ' << metric;
      ++rules;
      if (rule.borderline_from <= place->low && place->high <= rule.borderline_to) ++kept;
    }
    EXPECT_EQ(kept, rules) << name << ": nine of ten experts keep every rule, or miss it by little";
    const std::string text = io::read_text_file(experts->origin(), 1 << 20);
    EXPECT_EQ(text.find(",dangerous,"), std::string::npos) << name;
    int failed = 0;
    for (std::size_t at = text.find(",fail,"); at != std::string::npos; at = text.find(",fail,", at + 1)) ++failed;
    EXPECT_LE(failed, 3) << name;
  }
}

}  // namespace
}  // namespace bodkin
