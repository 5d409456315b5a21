#include "haptics/drivers/haply_messages.h"

#include <limits>

#include "tests/simulation/real_time_guard.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace bodkin {

using namespace bodkin::haptics;
namespace {

const std::string whole = R"({"inverse3":[{"device_id":"04BA","state":{
    "cursor_position":{"x":0.01,"y":-0.15,"z":2e-1},"cursor_velocity":{"x":-1,"y":0,"z":0.5},
    "current_cursor_force":{"x":0,"y":0,"z":0},"control_mode":"force"},
    "status":{"calibrated":true,"power_supply":true,"ready":true}}],
    "wireless_verse_grip":[{"device_id":"61576","state":{"orientation":{"w":0.5,"x":-0.5,"y":0.5,"z":-0.5},
    "buttons":{"a":true,"b":false,"c":true}},"status":{"connected":true,"awake":true}}]})";

class HaplyMessages : public testing::Test {
 protected:
  bool read(const std::string& text) {
    std::copy(text.begin(), text.end(), reader_.buffer().begin());
    return reader_.read(text.size(), reading_);
  }
  // With one part of the whole message replaced.
  bool read_with(const std::string& part, const std::string& instead) {
    std::string text = whole;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return read(text.replace(at, part.size(), instead));
  }

  HaplyStateReader reader_{"04BA", "61576"};
  HaplyReading reading_;
};

TEST_F(HaplyMessages, every_field_of_a_state_arrives) {
  ASSERT_TRUE(read(whole));
  EXPECT_TRUE(reading_.lists_devices && reading_.device_listed && reading_.has_position && reading_.has_velocity);
  EXPECT_EQ(reading_.position, Vec3(0.01, -0.15, 0.2));
  EXPECT_EQ(reading_.velocity, Vec3(-1.0, 0.0, 0.5));
  EXPECT_TRUE(reading_.calibrated && reading_.powered);
  EXPECT_FALSE(reading_.idle);
  EXPECT_TRUE(reading_.grip_listed && reading_.grip_awake && reading_.has_rotation && reading_.has_buttons);
  EXPECT_EQ(reading_.rotation, (std::array{0.5, -0.5, 0.5, -0.5}));
  EXPECT_EQ(reading_.buttons, 5u);
}

TEST_F(HaplyMessages, a_configuration_that_changes_the_axes_is_seen) {
  const auto with = [this](const std::string& config) {
    EXPECT_TRUE(read_with("\"status\":{\"cal", "\"config\":" + config + ",\"status\":{\"cal")) << config;
    EXPECT_TRUE(reading_.has_config) << config;
    return reading_.config_moved;
  };
  const std::string mount = R"({"position":{"x":0,"y":0,"z":0},"rotation":{"w":1,"x":0,"y":0,"z":0},)";
  EXPECT_FALSE(with("{}"));
  EXPECT_FALSE(with(R"({"basis":{"permutation":"XYZ"},"preset":"defaults","mount":)" + mount +
                    R"("scale":{"x":1,"y":1,"z":1}},"type":"inverse3","filters":{"force_gate":{"gain":0.3}}})"));
  EXPECT_FALSE(with(R"({"basis":"xyz","preset":null,"mount":null})"));
  EXPECT_TRUE(with(R"({"basis":{"permutation":"XZY"}})"));
  EXPECT_TRUE(with(R"({"basis":"-XYZ"})"));
  EXPECT_TRUE(with(R"({"preset":{"preset":"arm_front"}})"));
  EXPECT_TRUE(with(R"({"mount":)" + mount + R"("scale":{"x":1,"y":2,"z":1}}})"));
  EXPECT_TRUE(with(R"({"mount":{"transform":{"rotation":{"w":0.7,"x":0.7,"y":0,"z":0}}}})"));
  EXPECT_TRUE(read(whole));
  EXPECT_FALSE(reading_.has_config || reading_.config_moved);
  EXPECT_FALSE(read_with("\"status\":{\"cal", "\"config\":{\"basis\":7},\"status\":{\"cal"));
}

TEST_F(HaplyMessages, a_flag_that_is_down_is_seen) {
  EXPECT_TRUE(read_with("\"calibrated\":true", "\"calibrated\":false"));
  EXPECT_FALSE(reading_.calibrated);
  EXPECT_TRUE(read_with("\"power_supply\":true", "\"power_supply\":false"));
  EXPECT_FALSE(reading_.powered);
  EXPECT_TRUE(read_with("\"awake\":true", "\"awake\":false"));
  EXPECT_FALSE(reading_.grip_awake);
  EXPECT_TRUE(read_with("\"connected\":true", "\"connected\":false"));
  EXPECT_FALSE(reading_.grip_awake);
  EXPECT_TRUE(read_with("\"control_mode\":\"force\"", "\"control_mode\":\"idle\""));
  EXPECT_TRUE(reading_.idle);
}

TEST_F(HaplyMessages, older_names_of_buttons_and_of_the_grip_count_too) {
  EXPECT_TRUE(read_with(R"({"a":true,"b":false,"c":true})", R"({"button_3":true,"button_1":true,"button_0":false})"));
  EXPECT_EQ(reading_.buttons, 10u);
  for (const char* name : {"\"verse_grip\"", "\"custom_verse_grip\""}) {
    EXPECT_TRUE(read_with("\"wireless_verse_grip\"", name));
    EXPECT_TRUE(reading_.grip_listed) << name;
  }
}

TEST_F(HaplyMessages, a_mode_a_single_button_and_a_transform_are_read) {
  EXPECT_TRUE(read_with("\"control_mode\":\"force\"", "\"mode\":\"idle\""));
  EXPECT_TRUE(reading_.idle);
  EXPECT_TRUE(read_with(R"("buttons":{"a":true,"b":false,"c":true})", R"("button":true)"));
  EXPECT_EQ(reading_.buttons, 1u);
  EXPECT_TRUE(read_with(R"("buttons":{"a":true,"b":false,"c":true})", R"("button":{"b":true})"));
  EXPECT_EQ(reading_.buttons, 2u);
  EXPECT_FALSE(read_with(R"("buttons":{"a":true,"b":false,"c":true})", R"("button":7)"));
  EXPECT_TRUE(read_with("\"control_mode\":\"force\"", R"("transform":{"rotation":{"w":1,"x":0},"scale":{"z":1}})"));
  EXPECT_FALSE(reading_.moved);
  EXPECT_TRUE(read_with("\"control_mode\":\"force\"", R"("transform":{"rotation":{"w":0,"x":1}})"));
  EXPECT_TRUE(reading_.moved);
  EXPECT_FALSE(read_with("\"control_mode\":\"force\"", R"("transform":{"scale":{"x":"1"}})"));
}

TEST_F(HaplyMessages, the_order_of_the_fields_and_other_fields_do_not_matter) {
  EXPECT_TRUE(read(R"( {"a":[{"inverse3":[1,{}]}],"inverse3":[{"state":{"x":{"y":null},"cursor_position":
      {"w":7,"z":3,"y":2,"x":1}},"more":"}{\"","device_id":"04BA"}],"wireless_verse_grip":[]} )"));
  EXPECT_EQ(reading_.position, Vec3(1, 2, 3));
  EXPECT_FALSE(reading_.has_velocity || reading_.grip_listed);
}

TEST_F(HaplyMessages, another_device_and_another_grip_are_not_ours) {
  EXPECT_TRUE(read_with("04BA", "04BB"));
  EXPECT_TRUE(reading_.lists_devices);
  EXPECT_FALSE(reading_.device_listed || reading_.has_position);
  EXPECT_TRUE(read_with("61576", "6157"));
  EXPECT_FALSE(reading_.grip_listed || reading_.has_rotation);
  EXPECT_EQ(reading_.buttons, 0u);
}

TEST_F(HaplyMessages, parts_may_be_absent) {
  EXPECT_TRUE(read("{}"));
  EXPECT_FALSE(reading_.lists_devices);
  EXPECT_TRUE(read(R"({"inverse3":[]})"));
  EXPECT_TRUE(reading_.lists_devices);
  EXPECT_FALSE(reading_.device_listed);
  EXPECT_TRUE(read(R"({"inverse3":[{"device_id":"04BA"}]})"));
  EXPECT_TRUE(reading_.device_listed && reading_.calibrated && reading_.powered);
  EXPECT_FALSE(reading_.has_position);
}

TEST_F(HaplyMessages, numbers_that_are_none_are_damage) {
  for (const char* number : {"null", "NaN", "nan", "Infinity", "-inf", "1e999", "-1e400", "\"0.01\"", "0x10", "01",
                             ".5", "1.", "+1", "--1", "1e", "[]", "true", "{}"}) {
    EXPECT_FALSE(read_with("0.01", number)) << number;
  }
  EXPECT_TRUE(read_with("0.01", "1e-999"));  // smaller than a double can be is zero
  EXPECT_EQ(reading_.position.x(), 0.0);
  EXPECT_TRUE(read_with("0.01", "123456789012345678901234567890"));
  EXPECT_DOUBLE_EQ(reading_.position.x(), 123456789012345678901234567890.0);
}

TEST_F(HaplyMessages, a_vector_lacks_none_of_its_components) {
  EXPECT_FALSE(read_with("\"x\":0.01,", ""));
  EXPECT_FALSE(read_with("{\"x\":0.01,\"y\":-0.15,\"z\":2e-1}", "[0.01,-0.15,0.2]"));
  EXPECT_FALSE(read_with("\"w\":0.5,", ""));
}

TEST_F(HaplyMessages, what_is_cut_short_at_any_place_is_damage) {
  for (std::size_t size = 0; size < whole.size(); ++size) EXPECT_FALSE(read(whole.substr(0, size))) << size;
}

TEST_F(HaplyMessages, what_is_no_state_is_damage) {
  for (const char* text :
       {"", " ", "null", "7", "[]", "[{}]", "\"text\"", "{]", "{\"a\"}", "{\"inverse3\":{}}", "{\"inverse3\":[7]}",
        "{\"inverse3\":[{\"device_id\":7}]}", "{} {}", "{}x", "\xff\xfe", "{\"inverse3\":[{\"state\":[]}]}",
        "{\"verse_grip\":[{\"state\":{\"buttons\":{\"a\":1}}}]}"}) {
    EXPECT_FALSE(read(text)) << text;
  }
  EXPECT_FALSE(reader_.read(longest_haply_message + 1, reading_));
}

TEST_F(HaplyMessages, a_message_as_long_as_allowed_is_read) {
  std::string text = whole;
  text.insert(1, "\"words\":\"" + std::string(longest_haply_message - whole.size() - 11, 'a') + "\",");
  text.resize(longest_haply_message, ' ');
  EXPECT_TRUE(read(text));
  EXPECT_EQ(reading_.position, Vec3(0.01, -0.15, 0.2));
}

TEST_F(HaplyMessages, reading_and_writing_allocate_and_lock_nothing) {
  if (!RealTimeGuard::available()) GTEST_SKIP() << "a sanitizer owns malloc and the locks in this build";
  HaplyCommandWriter writer("04BA", HaplyForceKey::vector);
  std::string padded = whole;
  std::copy(padded.begin(), padded.end(), reader_.buffer().begin());
  std::size_t read = 0, written = 0;
  {
    const RealTimeGuard guard;
    for (int round = 0; round < 10; ++round) {
      read += reader_.read(padded.size(), reading_) ? 1 : 0;
      written += writer.force(Vec3(-1.0 / 3.0, 1e-300, 2.0)).size();
      read -= reader_.read(padded.size() / 2, reading_) ? 1 : 0;
    }
  }
  EXPECT_EQ(RealTimeGuard::heap_calls() + RealTimeGuard::lock_calls(), 0u);
  EXPECT_EQ(read, 10u);
  EXPECT_GT(written, 0u);
}

TEST(HaplyCommands, are_written_as_the_service_wants_them) {
  HaplyCommandWriter writer("04BA", HaplyForceKey::vector);
  EXPECT_EQ(
      writer.force(Vec3(1, -2.5, 0)),
      R"({"inverse3":[{"device_id":"04BA","commands":{"set_cursor_force":{"vector":{"x":1,"y":-2.5,"z":0}}}}]})");
  EXPECT_EQ(writer.introduction(),
            R"({"session":{"configure":{"profile":{"name":"org.bodkin.trainer"}}},)"
            R"("inverse3":[{"device_id":"04BA","commands":{"set_cursor_force":{"vector":{"x":0,"y":0,"z":0}}}}]})");
  EXPECT_EQ(writer.probe(), R"({"inverse3":[{"device_id":"04BA","commands":{"probe_position":{}}}]})");
}

TEST(HaplyCommands, of_the_older_interface_have_the_older_key) {
  HaplyCommandWriter writer("1.2:a", HaplyForceKey::values);
  EXPECT_EQ(writer.force(Vec3(0, 0, 3)),
            R"({"inverse3":[{"device_id":"1.2:a","commands":{"set_cursor_force":{"values":{"x":0,"y":0,"z":3}}}}]})");
}

TEST(HaplyCommands, lose_no_digit_and_hold_the_longest_numbers) {
  HaplyCommandWriter writer("04BA", HaplyForceKey::vector);
  const Vec3 force(-1.2345678901234567e-300, -std::numeric_limits<double>::max(), 0.1 + 0.2);
  const auto json = nlohmann::json::parse(writer.force(force));
  const auto& vector = json.at("inverse3").at(0).at("commands").at("set_cursor_force").at("vector");
  EXPECT_EQ(Vec3(vector.at("x"), vector.at("y"), vector.at("z")), force);
}

TEST(HaplyCommands, never_hold_what_is_no_number) {
  HaplyCommandWriter writer("04BA", HaplyForceKey::vector);
  const std::string nothing(writer.force(Vec3::Zero()));
  EXPECT_EQ(writer.force(Vec3(1, std::numeric_limits<double>::quiet_NaN(), 0)), nothing);
  EXPECT_EQ(writer.force(Vec3(0, 0, -std::numeric_limits<double>::infinity())), nothing);
}

}  // namespace
}  // namespace bodkin
