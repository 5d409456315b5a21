#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "session/session_file.h"

#include "core/progress.h"
#include "fem/solid/contact_body.h"
#include "simulation/operator_script.h"

namespace bodkin::session {

struct RunSettings {
  simulation::OperatorScript script;
  std::uint64_t seed = 1;
  anatomy::NeedlePath path;
  double longest = 120.0;                   // s of simulated time after which the run ends in any case; 1 to 3600
  std::optional<anatomy::TissueId> ending;  // the run ends when the tip touches this tissue
  bool realtime = false;                    // in real time instead of as fast as possible
  std::filesystem::path output;             // the session file
  bool overwrite = false;
  // Of the patient's deformable body, from patient::prepare_body(): the needle meets it off `path` too. May be null.
  std::shared_ptr<const fem::ContactBody> whole_body;
  std::function<bool()> cancelled;  // called before every tick, may be empty: true ends the run; the session is valid
};

struct RunResult {
  std::uint64_t ticks = 0;
  double wall_time = 0.0;          // s, duration of the loop
  bool operator_finished = false;  // false: the longest time had passed first, or the run was ended
  bool cancelled = false;
  std::optional<double> completed;     // mm below the skin, at which the tip touched RunSettings::ending
  std::string last_phase;              // of the operator
  std::uint64_t missed_deadlines = 0;  // realtime: ticks that began more than a tick late
  double worst_lateness = 0.0;         // s
  std::uint64_t records_lost = 0;      // realtime: ticks that the recorder dropped
  std::vector<std::string> notes;      // refusals of the system
};

// Whether the tip is in this tissue; false if empty.
bool is_touched(const simulation::TickOutput& output, const std::optional<anatomy::TissueId>& tissue) noexcept;

inline constexpr std::size_t largest_case_xml = std::size_t{16} << 20;  // bytes

// The part of a recording's header about its case, the path and the time; not about the operator.
SessionHeader session_header(const anatomy::Case& patient, const std::filesystem::path& case_folder,
                             const anatomy::NeedlePath& path);

// The part of a recording's header about its case and operator. `case_folder`: that of the case; its case.xml is
// read.
SessionHeader session_header(const anatomy::Case& patient, const std::filesystem::path& case_folder,
                             const RunSettings& settings);

// Performs the script on the patient with a simulated hand and records every tick. Without `realtime` the result
// depends only on the case, the script, the path and the seed. Throws InputError or SystemError.
RunResult run_session(const anatomy::Case& patient, const SessionHeader& header, const RunSettings& settings,
                      const Progress& progress);

}  // namespace bodkin::session
