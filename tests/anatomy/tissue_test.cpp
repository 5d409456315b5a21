#include "anatomy/tissue.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace bodkin {

using namespace bodkin::anatomy;
namespace {

TEST(TissueLibrary, finds_tissues_by_id_and_by_name) {
  const TissueLibrary library({{.id = tissue::skin, .name = "skin", .title = "skin"},
                               {.id = 40, .name = "tumour", .title = "tumour of the test"}});
  ASSERT_NE(library.find("tumour"), nullptr);
  EXPECT_EQ(library.find("tumour")->id, 40);
  EXPECT_EQ(library.find(TissueId{40}), library.find("tumour"));
  EXPECT_EQ(library.find(TissueId{41}), nullptr);
  EXPECT_EQ(library.find("bone"), nullptr);
  EXPECT_EQ(library.title(40), "tumour of the test");
  EXPECT_EQ(library.title(41), "tissue 41");
}

TEST(TissueLibrary, refuses_two_tissues_with_one_id_or_one_name) {
  const TissueProperties skin{.id = 1, .name = "skin", .title = "skin"};
  TissueProperties twin = skin;
  twin.name = "hide";
  EXPECT_THROW(TissueLibrary({skin, twin}), InputError);
  twin = skin;
  twin.id = 2;
  EXPECT_THROW(TissueLibrary({skin, twin}), InputError);
  twin = skin;
  twin.id = 255;
  EXPECT_THROW(TissueLibrary({twin}), InputError);
}

}  // namespace
}  // namespace bodkin
