#include "app/models/procedure_title.h"

#include <gtest/gtest.h>

#include "training/procedure_file.h"

namespace bodkin::app {
namespace {

TEST(ProcedureTitle, is_that_of_the_procedures_file) {
  EXPECT_EQ(procedure_title("ct_guided_biopsy"), "CT-guided biopsy");
  EXPECT_EQ(procedure_title("epidural"), "Lumbar epidural");
  for (const std::string& name : training::shipped_procedures())
    EXPECT_EQ(procedure_title(name), training::find_shipped_procedure(name).title) << name;
}

TEST(ProcedureTitle, of_another_is_its_name_as_people_read_it) {
  EXPECT_EQ(procedure_title("vertebroplasty_of_t12"), "Vertebroplasty of t12");
  EXPECT_EQ(procedure_title("../etc/passwd"), "../etc/passwd");
  EXPECT_EQ(procedure_title(""), "");
}

}  // namespace
}  // namespace bodkin::app
