#pragma once

#include <filesystem>
#include <string>

#include "anatomy/case.h"
#include "core/progress.h"
#include "io/experiment_file.h"

namespace bodkin::study {

struct PhantomRequest {
  std::filesystem::path folder;  // of the case; it must not exist unless `overwrite`
  bool overwrite = false;
  std::string name;  // of the case; empty: the experiment's
};

// Writes the body of an experiment (a stack of layers, or layers of a half ball) as a case, so that it can be felt on
// any device: its tissues, needle and force models, a CT of each tissue's HU, and the deepest line of its motion as
// the planned path. The body lies with its skin upwards, as a prone patient: depth runs towards -y (LPS), and the
// experiment's y becomes z. The needle reaches the end of the path. Returns the description. Throws InputError if the
// folder cannot be created, the body is too large, or the motion does not enter it.
anatomy::CaseDescription write_phantom(const io::Experiment& experiment, const PhantomRequest& wanted,
                                       const Progress& progress = {});

}  // namespace bodkin::study
