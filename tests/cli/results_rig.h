#pragma once

#include <cstdlib>
#include <filesystem>

#include "tests/cli/bodkin_command.h"

namespace bodkin_test {

// Commands about results, with a separate data folder and the session of an expert, session.bodkin.
class ResultsRig : public PatientCommand {
 protected:
  static void SetUpTestSuite() {
    PatientCommand::SetUpTestSuite();
    setenv("XDG_DATA_HOME", (folder_ / "data").c_str(), 1);
    unsetenv("BODKIN_STORE");
    if (made_.exit_code == 0)
      bodkin("-q run " + patient() + " --operator expert --output " + (folder_ / "session.bodkin").string());
  }
  static void TearDownTestSuite() {
    unsetenv("XDG_DATA_HOME");
    PatientCommand::TearDownTestSuite();
  }
  void SetUp() override {
    PatientCommand::SetUp();
    std::filesystem::remove_all(folder_ / "data");
  }
};

}  // namespace bodkin_test
