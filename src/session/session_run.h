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
  double longest = 120.0;  // s of simulated time after which the run ends whatever the operator does; 1 to 3600
  std::optional<anatomy::TissueId> ending;  // the run ends when the tip touches this tissue
  bool realtime = false;                    // on the clock instead of as fast as it goes
  std::filesystem::path output;             // the session file
  bool overwrite = false;
  // Of the patient's deformable body, from patient::prepare_body(): the needle meets it off `path` too. May be null.
  std::shared_ptr<const fem::ContactBody> whole_body;
  std::function<bool()> gives_up;  // asked before every tick, may be empty: true ends the run, whose session is whole
};

struct RunResult {
  std::uint64_t ticks = 0;
  double wall_time = 0.0;          // s that the loop took
  bool operator_finished = false;  // false: the longest time was over first, or it was given up
  bool given_up = false;
  std::optional<double> completed;     // mm below the skin, where the tip touched RunSettings::ending
  std::string last_phase;              // of the operator
  std::uint64_t missed_deadlines = 0;  // realtime: ticks that began more than a tick late
  double worst_lateness = 0.0;         // s
  std::uint64_t records_lost = 0;      // realtime: ticks that the recorder could not take
  std::vector<std::string> notes;      // what the system refused
};

// Whether the tip is in this tissue; false for none.
bool is_touched(const simulation::TickOutput& output, const std::optional<anatomy::TissueId>& tissue) noexcept;

inline constexpr std::size_t largest_case_xml = std::size_t{16} << 20;  // bytes

// What a recording says about its case, the path and the moment; nothing about who performs.
SessionHeader session_header(const anatomy::Case& patient, const std::filesystem::path& case_folder,
                             const anatomy::NeedlePath& path);

// What a recording says about its case and operator. `case_folder`: where the case lies; its case.xml is read.
SessionHeader session_header(const anatomy::Case& patient, const std::filesystem::path& case_folder,
                             const RunSettings& settings);

// Lets a simulated hand perform the script on the patient and records every tick. Without `realtime` nothing but the
// case, the script, the path and the seed decides what happens. Throws InputError or SystemError.
RunResult run_session(const anatomy::Case& patient, const SessionHeader& header, const RunSettings& settings,
                      const Progress& progress);

}  // namespace bodkin::session
