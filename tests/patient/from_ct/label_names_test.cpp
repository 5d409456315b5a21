#include "patient/from_ct/label_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace bodkin {

using namespace bodkin::anatomy;
using namespace bodkin::patient;
namespace {

using testing::HasSubstr;

Structure structure_of(const std::string& name) {
  const NamedStructures named = structures_named({{5, name}});
  EXPECT_EQ(named.table.size(), 1U);
  EXPECT_EQ(named.table.front().label, 5);
  return named.table.front();
}

TEST(LabelNames, that_a_scheme_lists_are_taken_as_such_however_they_are_written) {
  for (const char* name : {"kidney_left", "Left kidney", "Kidney (L)", "KIDNEY LT"}) {
    EXPECT_EQ(structure_of(name).name, "kidney_left") << name;
    EXPECT_EQ(structure_of(name).tissue, "organ") << name;
    EXPECT_TRUE(structure_of(name).critical) << name;
  }
  for (const char* name : {"L3", "vertebra L3", "L3 vertebral body", "VB_L3"})
    EXPECT_EQ(structure_of(name).name, "vertebrae_L3") << name;
  EXPECT_EQ(structure_of("Aorta").tissue, "vessel");
}

TEST(LabelNames, of_tumours_are_masses_and_others_are_kept_and_told) {
  for (const char* name : {"GTV_Mass_CT", "GTVp", "Liver lesion 2", "tumour"})
    EXPECT_EQ(structure_of(name).tissue, "mass") << name;
  EXPECT_EQ(structure_of("Lung nodule S2").tissue, "mass") << "S2 is a segment of the lung here, no vertebra";
  const NamedStructures named = structures_named({{1, "PTV 50Gy"}, {2, "Liver"}, {3, ""}});
  EXPECT_EQ(named.table[0].name, "ptv_50gy");
  EXPECT_EQ(named.table[0].tissue, "");
  EXPECT_EQ(named.table[2].name, "label_3");
  EXPECT_THAT(named.notes, testing::ElementsAre(HasSubstr("'PTV 50Gy', ''")));
}

TEST(LabelNames, that_say_cord_are_taken_for_the_canal_with_a_note) {
  const NamedStructures named = structures_named({{1, "Spinal Cord"}});
  EXPECT_EQ(named.table[0].tissue, "spinal_canal");
  EXPECT_THAT(named.notes, testing::ElementsAre(HasSubstr("whole spinal canal")));
}

}  // namespace
}  // namespace bodkin
