#include "core/parameter.h"

#include <cmath>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/settings_tree.h"

namespace bodkin {
namespace {

enum class Shade : std::uint8_t { light, dark };
constexpr std::array<std::string_view, 2> enumeration_names(Shade) {
  return {"light", "dark"};
}

struct Layer {
  double from = 0.0;
  double force = 1.0;

  static constexpr auto parameters() {
    return std::tuple{Parameter{"from_mm", &Layer::from, Range{0.0, 100.0}, "mm", "where it begins", Origin::choice},
                      Parameter{"force_N", &Layer::force, above(0.0, 10.0), "N", "its force", Origin::paper}};
  }
};

struct Wheel {
  int spokes = 12;

  static constexpr auto parameters() {
    return std::tuple{Parameter{"spokes", &Wheel::spokes, Range{3, 36}, "", "in the wheel", Origin::choice}};
  }
};

struct Everything {
  double least = 0.5;
  double time = 1.0;
  bool strict = false;
  Shade shade = Shade::light;
  Vec3 up = Vec3::UnitZ();
  Layer base;
  Wheel front{16};
  std::optional<Wheel> spare;
  std::vector<Layer> layers;

  static constexpr auto parameters() {
    using S = Everything;
    return std::tuple{Parameter{"least_N", &S::least, Range{0.0, 10.0}, "N", "the least force", Origin::literature},
                      Parameter{"time_s", &S::time, Range{1e-3, unbounded}, "s", "the time", Origin::choice},
                      Parameter{"strict", &S::strict, "to the letter", Origin::choice},
                      Parameter{"shade", &S::shade, "of the thing", Origin::choice},
                      Component{"up_x", &S::up, 0, {-1.0, 1.0}, "", "against gravity", Origin::choice}.joint(),
                      Component{"up_y", &S::up, 1, {-1.0, 1.0}, "", "against gravity", Origin::choice}.joint(),
                      Component{"up_z", &S::up, 2, {-1.0, 1.0}, "", "against gravity", Origin::choice}.joint(),
                      Inlined{&S::base},
                      ChildElement{"front", &S::front, "the wheel in front"},
                      ChildElement{"spare", &S::spare, "the wheel in the boot"},
                      ChildElements{"layer", &S::layers, "what it is made of", 2}};
  }
  static constexpr auto relations() {
    using S = Everything;
    return std::tuple{AtMost{&S::least, &S::time}, Rising{&S::layers, &Layer::from, 0.0},
                      Relation<S>{[](const S& s) { return !(s.strict && s.shade == Shade::dark); },
                                  "strict is true of a dark one, expected false"}};
  }
};

struct Choice {
  Shade shade = Shade::light;
  double brightness = 1.0;

  static constexpr auto parameters() {
    using S = Choice;
    return std::tuple{
        Alternatives{&S::shade, "what it is"},
        Parameter{"brightness", &S::brightness, Range{0.0, 2.0}, "", "of a light one", Origin::choice}.only_of(
            "light")};
  }
};

std::string complaint(const auto& settings) {
  try {
    check(settings, "file, line 3: thing");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string complaint_of_tree(const SettingsTree& tree) {
  try {
    settings_from<Everything>(tree, "file");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Parameter, defaults_are_in_order) {
  EXPECT_EQ(complaint(Everything{}), "");
  EXPECT_EQ(complaint(Choice{}), "");
}

TEST(Parameter, a_value_out_of_range_is_named_with_its_unit_and_range) {
  Everything settings;
  settings.least = 10.5;
  EXPECT_EQ(complaint(settings), "file, line 3: thing: least_N is 10.5 N, expected 0 to 10 N");
  settings.least = std::nan("");
  EXPECT_EQ(complaint(settings), "file, line 3: thing: least_N is nan N, expected 0 to 10 N");
  settings = {};
  settings.base.force = 0.0;
  EXPECT_EQ(complaint(settings), "file, line 3: thing: force_N is 0 N, expected more than 0 and at most 10 N");
  settings = {};
  settings.time = 0.0;
  EXPECT_EQ(complaint(settings), "file, line 3: thing: time_s is 0 s, expected 0.001 s to infinity");
  settings.time = unbounded;
  EXPECT_EQ(complaint(settings), "");
  settings.up.y() = -2.0;
  EXPECT_EQ(complaint(settings), "file, line 3: thing: up_y is -2, expected -1 to 1");
}

TEST(Parameter, what_lies_inside_is_checked_too) {
  Everything settings;
  settings.front.spokes = 2;
  EXPECT_EQ(complaint(settings), "file, line 3: thing, front: spokes is 2, expected 3 to 36");
  settings = {};
  settings.spare = Wheel{40};
  EXPECT_EQ(complaint(settings), "file, line 3: thing, spare: spokes is 40, expected 3 to 36");
  settings = {};
  settings.layers = {{0.0, 1.0}, {3.0, 20.0}};
  EXPECT_EQ(complaint(settings),
            "file, line 3: thing, layer: force_N is 20 N, expected more than 0 and at most 10 N");
  settings.layers = {{0.0, 1.0}, {3.0, 1.0}, {4.0, 1.0}};
  EXPECT_EQ(complaint(settings), "file, line 3: thing: there are 3 elements layer, expected at most 2");
}

TEST(Parameter, relations_between_parameters_are_checked) {
  Everything settings;
  settings.least = 2.0;
  EXPECT_EQ(complaint(settings), "file, line 3: thing: least_N is 2 N, expected at most the time_s of 1 s");
  settings = {};
  settings.layers = {{1.0, 1.0}};
  EXPECT_EQ(complaint(settings), "file, line 3: thing: from_mm of element 1 is 1, expected 0 for the first one");
  settings.layers = {{0.0, 1.0}, {0.0, 1.0}};
  EXPECT_EQ(complaint(settings),
            "file, line 3: thing: from_mm of element 2 is 0, expected more than the 0 of the one before");
  settings = {};
  settings.strict = true;
  settings.shade = Shade::dark;
  EXPECT_EQ(complaint(settings), "file, line 3: thing: strict is true of a dark one, expected false");
}

TEST(Parameter, of_alternatives_only_those_of_the_chosen_one_count) {
  Choice choice{Shade::light, 3.0};
  EXPECT_EQ(complaint(choice), "file, line 3: thing: brightness is 3, expected 0 to 2");
  choice.shade = Shade::dark;
  EXPECT_EQ(complaint(choice), "");
  EXPECT_EQ(tree_text(settings_tree("choice", choice)), "choice; dark");
  EXPECT_EQ(tree_text(settings_tree("choice", Choice{Shade::light, 0.5})), "choice; light brightness=0.5");
  const SettingsTree bright{
      .name = "choice", .values = {}, .children = {{.name = "light", .values = {{"brightness", "2"}}}}};
  EXPECT_EQ(settings_from<Choice>(bright, "file").brightness, 2.0);
  EXPECT_THROW(settings_from<Choice>({.name = "choice"}, "file"), InputError);
}

TEST(Parameter, settings_become_text_and_the_same_bits_again) {
  Everything settings;
  settings.least = 0.1 + 0.2;
  settings.time = unbounded;
  settings.strict = true;
  settings.up = Vec3(-0.6, 1.0 / 3.0, 5e-324);
  settings.spare = Wheel{7};
  settings.layers = {{0.0, 1e-3}, {1e2, 10.0}};
  const SettingsTree tree = settings_tree("everything", settings);
  EXPECT_EQ(
      tree_text(tree),
      "everything least_N=0.30000000000000004 time_s=INF strict=true shade=light up_x=-0.6 "
      "up_y=0.3333333333333333 up_z=5e-324 from_mm=0 force_N=1; front spokes=16; spare spokes=7; layer from_mm=0 "
      "force_N=0.001; layer from_mm=100 force_N=10");
  EXPECT_TRUE(same_parameters(settings_from<Everything>(tree, "file"), settings));
}

TEST(Parameter, what_a_text_does_not_say_keeps_its_default) {
  const auto settings = settings_from<Everything>({.name = "everything", .values = {{"shade", "dark"}}}, "file");
  Everything expected;
  expected.shade = Shade::dark;
  EXPECT_TRUE(same_parameters(settings, expected));
  EXPECT_FALSE(same_parameters(settings, Everything{}));
}

TEST(Parameter, texts_that_mean_nothing_are_refused) {
  EXPECT_EQ(complaint_of_tree({.name = "thing", .values = {{"strict", "perhaps"}}, .children = {}, .line = 4}),
            "file, line 4: thing: strict is 'perhaps', expected true or false");
  EXPECT_EQ(complaint_of_tree({.name = "thing", .values = {{"shade", "grey"}}}),
            "file: thing: shade is 'grey', expected light or dark");
  for (const char* text : {"", "1.5 N", "nan", "inf", "0x10", "1e999", "--1", "1e"}) {
    EXPECT_THAT(complaint_of_tree({.name = "thing", .values = {{"least_N", text}}}),
                testing::HasSubstr("', expected a number"))
        << text;
  }
  EXPECT_THAT(complaint_of_tree({.name = "thing", .values = {{"most_N", "1"}}}),
              testing::HasSubstr("thing: has the unknown setting most_N; it takes least_N, time_s, strict"));
  EXPECT_THAT(complaint_of_tree({.name = "thing", .values = {}, .children = {{.name = "rear"}}}),
              testing::HasSubstr("thing: has the unknown element rear; it takes front, spare, layer"));
  EXPECT_THAT(complaint_of_tree({.name = "thing", .values = {}, .children = {{.name = "front"}, {.name = "front"}}}),
              testing::HasSubstr("the element front is given 2 times, expected it once at most"));
  EXPECT_THAT(complaint_of_tree({.name = "thing", .values = {{"up_x", "1"}}}),
              testing::HasSubstr("1 of the 3 components of a vector are given, expected all or none"));
}

TEST(Parameter, numbers_are_read_as_xml_writes_them) {
  double value = 7.0;
  EXPECT_TRUE(parse_number(" +2.5\n", value));
  EXPECT_EQ(value, 2.5);
  EXPECT_TRUE(parse_number("INF", value));
  EXPECT_EQ(value, unbounded);
  EXPECT_TRUE(parse_number("1e-999", value));
  EXPECT_EQ(value, 0.0);
  EXPECT_TRUE(parse_number(".5", value));
  EXPECT_EQ(value, 0.5);
}

struct Axle {
  double width = 10.0;
  double load = 5.0;

  static constexpr auto parameters() {
    return std::tuple{Parameter{"width_mm", &Axle::width, Range{1.0, 20.0}, "mm", "of the axle", Origin::choice}};
  }
  static constexpr auto unwritten() {
    return std::tuple{Parameter{"load_N", &Axle::load, Range{0.0, 9.0}, "N", "of the wheels", Origin::choice}};
  }
};

TEST(Parameter, what_is_stated_elsewhere_is_checked_and_not_written) {
  EXPECT_EQ(settings_tree("axle", Axle{}).values.size(), 1U);
  EXPECT_NO_THROW(check(Axle{}, "axle"));
  try {
    check(Axle{.load = 9.5}, "axle");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "axle: load_N is 9.5 N, expected 0 to 9 N");
  }
}

TEST(Parameter, a_member_knows_its_declaration) {
  const DeclaredParameter declared = declaration_of(&Layer::force);
  EXPECT_EQ(declared.name, "force_N");
  EXPECT_EQ(declared.unit, "N");
  EXPECT_EQ(declared.range.high, 10.0);
  EXPECT_FALSE(declared.range.includes_low);
}

TEST(Parameter, a_name_ends_with_its_unit) {
  EXPECT_EQ(name_without_unit("stiffness_N_per_mm", "N/mm"), "stiffness");
  EXPECT_EQ(name_without_unit("viscous_N_s_per_mm2", "N s/mm^2"), "viscous");
  EXPECT_EQ(name_without_unit("stiffening_N_per_mm_s", "N/(mm s)"), "stiffening");
  EXPECT_EQ(name_without_unit("curvature_per_mm", "1/mm"), "curvature");
  EXPECT_EQ(name_without_unit("catch_up_s", "s"), "catch_up");
  EXPECT_EQ(name_without_unit("roughness", ""), "roughness");
  EXPECT_EQ(name_without_unit("pause", "s"), "pause") << "without one it stays";
}

TEST(Parameter, every_parameter_is_met_once) {
  std::multiset<std::string_view> names;
  for_each_parameter([&](const auto& parameter, const auto&) { names.insert(parameter.name); }, Everything{});
  EXPECT_EQ(names, (std::multiset<std::string_view>{"least_N", "time_s", "strict", "shade", "up_x", "up_y", "up_z",
                                                    "from_mm", "force_N"}));
}

}  // namespace
}  // namespace bodkin
