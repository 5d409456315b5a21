#pragma once

#include "patient/synthetic/lumbar.h"

#include "anatomy/case.h"
#include "io/tissue_library_file.h"

namespace bodkin {

// The synthetic patient of a lumbar puncture; `spacing` in mm.
inline anatomy::Case lumbar_patient_of(double spacing) {
  anatomy::Case made;
  made.library = io::default_tissue_library();
  patient::SyntheticPatient torso = patient::synthesize_lumbar({.spacing = spacing}, made.library);
  made.ct = std::move(torso.ct);
  made.tissues = std::move(torso.tissues);
  made.structures = std::move(torso.structures);
  made.description.structures = std::move(torso.structure_table);
  made.description.landmarks = std::move(torso.landmarks);
  made.description.procedure.path = torso.path;
  made.description.procedure.target_tissue = "cerebrospinal_fluid";
  return made;
}

// With voxels of 1.5 mm, made once for all tests of a program.
inline const anatomy::Case& lumbar_patient() {
  static const anatomy::Case patient = lumbar_patient_of(1.5);
  return patient;
}

}  // namespace bodkin
