#include "patient/from_ct/vertebral_levels.h"

#include "patient/from_ct/spine_view.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

// Names of interspaces: counted from both ends, by labels, by the user's statement, or none.

namespace bodkin::patient {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::uint8_t l(int number) {
  return static_cast<std::uint8_t>(spine_role::l1 + number - 1);
}

// Interspaces 30 mm apart from T12/L1 at z = 180 down to L5/S1 at z = 30, without labels.
LevelEvidence lumbar_spine() {
  LevelEvidence evidence;
  for (int n = 0; n < 6; ++n) evidence.interspaces.push_back({180.0 - 30.0 * n, 0, 0});
  return evidence;
}

const auto all_names = ElementsAre("T12_L1", "L1_L2", "L2_L3", "L3_L4", "L4_L5", "L5_S1");
const auto all_numbers =
    ElementsAre("interspace_6", "interspace_5", "interspace_4", "interspace_3", "interspace_2", "interspace_1");

TEST(VertebralLevels, both_ends_name_the_levels_with_high_confidence) {
  LevelEvidence evidence = lumbar_spine();
  evidence.sacrum = 28.0, evidence.lowest_rib = 205.0;
  const VertebralLevels levels = name_levels(evidence);
  EXPECT_THAT(levels.names, all_names);
  EXPECT_EQ(levels.confidence, LevelConfidence::high);
  EXPECT_THAT(levels.evidence, HasSubstr("up from the sacrum at z = 28"));
  EXPECT_THAT(levels.evidence, HasSubstr("T12, at z = 205"));
  EXPECT_EQ(levels.places.front(), 1.0);
  EXPECT_EQ(levels.places.back(), 6.0);
}

TEST(VertebralLevels, a_sixth_or_a_missing_lumbar_vertebra_names_nothing_and_says_why) {
  LevelEvidence six = lumbar_spine();
  six.interspaces.insert(six.interspaces.begin(), {210.0, 0, 0});
  six.sacrum = 28.0, six.lowest_rib = 235.0;
  const VertebralLevels levels = name_levels(six);
  EXPECT_FALSE(levels.known());
  EXPECT_EQ(levels.names.front(), "interspace_7");
  EXPECT_THAT(levels.evidence, HasSubstr("6 vertebrae instead of 5, a transitional vertebra"));
  LevelEvidence four = lumbar_spine();
  four.interspaces.pop_back();
  four.sacrum = 58.0, four.lowest_rib = 205.0;
  EXPECT_THAT(name_levels(four).evidence, HasSubstr("4 vertebrae instead of 5"));
}

TEST(VertebralLevels, a_sacrum_with_its_interspace_in_sight_is_enough_unless_the_crests_disagree) {
  LevelEvidence evidence = lumbar_spine();
  evidence.sacrum = 28.0;
  EXPECT_THAT(name_levels(evidence).names, all_names);
  EXPECT_EQ(name_levels(evidence).confidence, LevelConfidence::moderate);
  evidence.iliac_crest = 62.0;
  EXPECT_THAT(name_levels(evidence).evidence, HasSubstr("the iliac crests, at z = 62, fit"));
  evidence.iliac_crest = 100.0;
  EXPECT_THAT(name_levels(evidence).names, all_numbers);
  EXPECT_THAT(name_levels(evidence).evidence, HasSubstr("would not lie near L4/L5"));
}

TEST(VertebralLevels, an_l5_s1_that_is_not_seen_does_not_shift_the_names) {
  LevelEvidence evidence = lumbar_spine();
  evidence.interspaces.pop_back();  // merged with the sacrum: L4/L5, at z = 60, is the lowest gap
  evidence.sacrum = 32.0;
  EXPECT_FALSE(name_levels(evidence).known()) << "nothing confirms it";
  evidence.iliac_crest = 65.0;
  EXPECT_THAT(name_levels(evidence).names, ElementsAre("T12_L1", "L1_L2", "L2_L3", "L3_L4", "L4_L5"));
  evidence.lowest_rib = 205.0;
  EXPECT_EQ(name_levels(evidence).confidence, LevelConfidence::high);
}

TEST(VertebralLevels, ribs_alone_name_nothing_because_the_twelfth_may_be_too_short_to_be_seen) {
  LevelEvidence evidence = lumbar_spine();
  evidence.lowest_rib = 205.0;
  EXPECT_THAT(name_levels(evidence).names, all_numbers);
  EXPECT_THAT(name_levels(evidence).evidence, HasSubstr("nothing confirms"));
  evidence.iliac_crest = 62.0;
  EXPECT_THAT(name_levels(evidence).names, all_names);
  evidence.lowest_rib = 235.0;  // of T11: the crests then lie near L5/S1
  EXPECT_THAT(name_levels(evidence).names, all_numbers);
}

TEST(VertebralLevels, without_evidence_there_are_only_numbers) {
  const VertebralLevels levels = name_levels(lumbar_spine());
  EXPECT_THAT(levels.names, all_numbers);
  EXPECT_THAT(levels.places, testing::Each(testing::Eq(std::nullopt)));
  EXPECT_THAT(levels.evidence, HasSubstr("neither the sacrum nor the lowest ribs"));
  EXPECT_TRUE(name_levels({}).names.empty());
}

TEST(VertebralLevels, labels_name_them_when_they_follow_each_other) {
  LevelEvidence evidence;
  evidence.interspaces = {{90.0, l(3), l(4)}, {60.0, l(4), l(5)}, {30.0, l(5), spine_role::sacrum}};
  EXPECT_THAT(name_levels(evidence).names, ElementsAre("L3_L4", "L4_L5", "L5_S1"));
  EXPECT_EQ(name_levels(evidence).confidence, LevelConfidence::high);
  evidence.interspaces = {{120.0, 12, l(1)}, {90.0, 0, 0}, {60.0, l(2), l(3)}};
  EXPECT_THAT(name_levels(evidence).names, ElementsAre("T12_L1", "L1_L2", "L2_L3"))
      << "gaps between labels are counted";
  evidence.interspaces = {{90.0, l(2), l(4)}};
  EXPECT_THAT(name_levels(evidence).evidence, HasSubstr("do not follow each other: L2 lies on L4"));
  evidence.interspaces = {{90.0, l(3), l(4)}, {60.0, l(3), l(4)}};
  EXPECT_FALSE(name_levels(evidence).known());
}

TEST(VertebralLevels, labels_of_a_transitional_vertebra_are_kept_and_said) {
  LevelEvidence evidence;
  evidence.interspaces = {{60.0, l(5), l(6)}, {30.0, l(6), spine_role::sacrum}};
  EXPECT_THAT(name_levels(evidence).names, ElementsAre("L5_L6", "L6_S1"));
  EXPECT_THAT(name_levels(evidence).evidence, HasSubstr("transitional"));
}

TEST(VertebralLevels, the_users_word_overrules_everything) {
  LevelEvidence evidence = lumbar_spine();
  evidence.lowest_vertebra = "L4";
  EXPECT_THAT(name_levels(evidence).names, ElementsAre("T11_T12", "T12_L1", "L1_L2", "L2_L3", "L3_L4", "L4_L5"));
  EXPECT_EQ(name_levels(evidence).confidence, LevelConfidence::stated);
  evidence.lowest_vertebra = "L6";
  EXPECT_EQ(name_levels(evidence).names.back(), "L6_S1");
  EXPECT_EQ(name_levels(evidence).names[4], "L5_L6");
  evidence.lowest_vertebra = "five";
  EXPECT_THROW(name_levels(evidence), InputError);
}

TEST(VertebralLevels, a_puncture_needs_l2_l3_and_a_whole_vertebra_below_the_cord) {
  const auto at = [](const char* name) { return *interspace_named(name); };
  EXPECT_TRUE(may_plan_at(at("L2_L3"), adult_conus));
  EXPECT_FALSE(may_plan_at(at("L1_L2"), adult_conus));
  EXPECT_FALSE(may_plan_at(at("L1_L2"), *place_named("T12"))) << "a high conus allows no higher puncture";
  EXPECT_FALSE(may_plan_at(at("L2_L3"), *place_named("L2")));
  EXPECT_TRUE(may_plan_at(at("L3_L4"), *place_named("L2")));
  EXPECT_FALSE(may_plan_at(at("L3_L4"), conus_at_age(0.0))) << "the cord of the newborn ends at L3";
  EXPECT_TRUE(may_plan_at(at("L4_L5"), conus_at_age(0.0)));
}

TEST(VertebralLevels, places_have_names_both_ways) {
  EXPECT_EQ(place_named("L1"), 1.5);
  EXPECT_EQ(place_named("T12"), 0.5);
  EXPECT_EQ(place_named("L3_L4"), 4.0);
  EXPECT_EQ(interspace_named("L5_S1"), 6.0);
  EXPECT_EQ(interspace_named("L3"), std::nullopt);
  EXPECT_EQ(place_named("C7"), std::nullopt);
  EXPECT_EQ(describe_place(adult_conus), "lower third of L1");
  EXPECT_EQ(describe_place(2.0), "interspace L1_L2");
  EXPECT_EQ(describe_place(conus_at_age(0.0)), "middle of L3");
  EXPECT_EQ(conus_at_age(2.0), adult_conus);
  EXPECT_EQ(conus_at_age(40.0), adult_conus);
}

}  // namespace
}  // namespace bodkin::patient
