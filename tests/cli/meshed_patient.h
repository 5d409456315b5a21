#pragma once

#include <cstdlib>

#include "tests/cli/bodkin_command.h"
#include "tests/cli/mesher_rig.h"

namespace bodkin_test {

// A copy of the default patient with a mesh, in `patient`, as `bodkin case synthesize lumbar` and `bodkin case mesh`
// make them.
class MeshedPatient : public BodkinCommand {
 protected:
  static void SetUpTestSuite() {
    BodkinCommand::SetUpTestSuite();
    if (!mesher_built) return;
    setenv("BODKIN_MESHER_WORKER", BODKIN_BUILD "/bin/bodkin-mesher", 1);
    static const SyntheticPatient original("meshed", {"-q case synthesize lumbar patient", "-q case mesh patient"});
    made_ = original.made;
    if (made_.exit_code == 0) original.copy_to(folder_);
  }
  void SetUp() override {
    BODKIN_NEEDS_MESHER();
    ASSERT_EQ(made_.exit_code, 0) << made_.errors;
  }

 private:
  static inline Outcome made_;
};

}  // namespace bodkin_test
