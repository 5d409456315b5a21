#include "app/models/station_patient.h"

#include <chrono>
#include <string>
#include <thread>

#include "link/station_watch.h"
#include <fmt/format.h>

#include "core/error.h"
#include "io/case_folder.h"
#include "io/digest.h"

namespace bodkin::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds patience_with_station{5};
constexpr std::chrono::milliseconds time_between_looks{20};

// The station's description of its patient; a running session also reports its tissues.
link::StationView ask(const link::ClientSettings& server) {
  const link::StationWatch watch(server);
  link::StationView view;
  for (const auto end = Clock::now() + patience_with_station; Clock::now() < end;
       std::this_thread::sleep_for(time_between_looks)) {
    view = watch.view();
    if (!view.patient.empty()) return view;
  }
  if (!view.status.sentence.empty()) throw InputError(view.status.sentence);
  throw InputError(
      fmt::format("the station at {} does not say which patient it has; name the copy of its case: "
                  "bodkin app CASE --connect {}",
                  view.place, view.place));
}

bool is_patient(const fs::path& folder, const link::StationView& station) {
  try {
    const anatomy::CaseDescription description = io::read_case_description(folder);
    if (description.name != station.patient) return false;
    return station.tissues_digest.empty() ||
           io::volume_digest(io::load_case_tissues(folder, description, {})) == station.tissues_digest;
  } catch (const std::exception&) {
    return false;  // a damaged case is not the requested one
  }
}

}  // namespace

fs::path patient_of_station(const link::ClientSettings& server, std::span<const fs::path> folders) {
  const link::StationView station = ask(server);
  for (const fs::path& folder : folders) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      if (fs::exists(entry.path() / "case.xml", ignored) && is_patient(entry.path(), station)) return entry.path();
    }
  }
  throw InputError(
      fmt::format("the station at {} has the patient '{}', whose case is not on this computer; copy its folder, and "
                  "name the copy: bodkin app CASE --connect {}",
                  station.place, station.patient, station.place));
}

}  // namespace bodkin::app
