#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "session/session_file.h"

#include "fem/solid/contact_body.h"
#include "simulation/operator_script.h"

namespace bodkin::training {

struct AttemptOptions {
  std::optional<anatomy::TissueId> ending = {};  // the attempt ends when the tip touches this tissue
  // s after which it ends in any case; the session then counts as finished too.
  double longest = 120.0;
  // Of the patient's deformable body, from patient::prepare_body(): the needle meets it off `path` too. May be null.
  std::shared_ptr<const fem::ContactBody> whole_body = {};
};

// Lets a simulated operator perform on a patient, as fast as possible, and keeps the session in memory: the same
// ticks as `bodkin run` records with this case, script, path and seed. Without diagnostics and without the data that
// only a file has (case.xml, digest, time). Throws InputError for an invalid script, path or patient.
session::Session simulate_attempt(const anatomy::Case& patient, const simulation::OperatorScript& script,
                                  const anatomy::NeedlePath& path, std::uint64_t seed,
                                  const AttemptOptions& options = {});

}  // namespace bodkin::training
