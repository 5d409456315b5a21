#include "station/ultrasound_request.h"

#include <functional>

#include <gmock/gmock.h>

#include "core/error.h"

namespace bodkin::station {
namespace {

using ::testing::HasSubstr;

std::string refusal_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(UltrasoundRequest, comes_back_from_its_json_with_every_value) {
  UltrasoundRequest request;
  request.probe = "L14-5";
  request.at = "L3_L4";
  request.view = "transverse";
  request.tgc = "1,2,3,4,5,6,7,8";
  request.gain = -4.0;
  request.press = 2.5;
  request.needle_depth = 31.25;
  request.frequency = 9.0;
  request.slices = 5;
  request.no_gel = request.needle = true;
  const UltrasoundRequest read = ultrasound_request(to_json(request));
  EXPECT_EQ(to_json(read), to_json(request));
  EXPECT_EQ(read.at, "L3_L4");
  EXPECT_EQ(read.needle_depth, 31.25);
  EXPECT_FALSE(read.depth.has_value());
  const UltrasoundChoice choice = choose_ultrasound(read);
  EXPECT_EQ(choice.probe.name, "L14-5");
  EXPECT_EQ(choice.settings.sliders[7], 8.0);
  EXPECT_EQ(choice.settings.depth, choice.probe.depth);
  EXPECT_EQ(choice.press, 2.5);
  EXPECT_EQ(choice.at_name, "L3_L4");
  EXPECT_FALSE(choice.settings.gel);
}

TEST(UltrasoundRequest, a_probe_held_by_numbers_is_not_pressed_unless_asked) {
  UltrasoundRequest request;
  EXPECT_EQ(choose_ultrasound(request).press, 3.0);
  request.face = "0,100,0";
  request.look = "0,-1,0";
  EXPECT_EQ(choose_ultrasound(request).press, 0.0);
}

TEST(UltrasoundRequest, what_cannot_be_is_refused_by_the_name_of_its_option) {
  UltrasoundRequest request;
  request.slices = 4;
  EXPECT_THAT(refusal_of([&] { choose_ultrasound(request); }), HasSubstr("--slices"));
  EXPECT_THAT(refusal_of([] { ultrasound_request("{"); }), HasSubstr("JSON"));
  EXPECT_THAT(refusal_of([] { ultrasound_request(R"({"depth_mm": "deep"})"); }), HasSubstr("JSON"));
}

}  // namespace
}  // namespace bodkin::station
