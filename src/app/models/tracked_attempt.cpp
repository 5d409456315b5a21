#include "app/models/tracked_attempt.h"

#include <utility>

#include "app/models/data_folder.h"
#include "tracking/tool_driver.h"
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::app {

namespace {

// A word of a driver's settings.
std::string setting_word(const char* key, const std::filesystem::path& value) {
  return value.empty() ? std::string() : fmt::format("{}=\"{}\" ", key, value.string());
}

}  // namespace

TrackedAttempt::TrackedAttempt(const std::shared_ptr<const OpenCase>& patient, const tracking::FootageFiles& files,
                               const std::filesystem::path& registration,
                               const std::optional<station::UltrasoundChoice>& ultrasound) {
  const std::optional<anatomy::NeedlePath>& path = patient->description().procedure.path;
  if (!path) throw InputError("this patient has no planned path by which an attempt is judged; plan one first");
  station::StationOptions options;
  options.patient = patient->patient;
  options.case_folder = patient->folder;
  options.path = *path;
  options.device = {&tracking::tool_driver(), files.source,
                    setting_word("camera", files.camera) + setting_word("bodies", files.bodies) +
                        setting_word("registration", registration)};
  options.ultrasound = ultrasound;
  options.output = new_session_file(patient->title);
  options.longest = 3600.0;
  link_.start(std::move(options), "Tracked needle", {true, ""}, tissue_.follow({}, *path, patient->patient.tissues));
}

const StationUpdate& TrackedAttempt::poll() {
  const StationUpdate& news = link_.poll();
  moved_ = tissue_.now(news.displacements);
  return news;
}

std::string TrackedAttempt::sentence(const StationUpdate& news) {
  using Phase = StationUpdate::Phase;
  switch (news.phase) {
    case Phase::idle:
    case Phase::preparing:
      return "The recording begins as soon as needle and mannequin are seen.";
    case Phase::running:
      return news.needle.unseen
                 ? fmt::format("Recording, {:.0f} s: the needle is NOT SEEN and rests where it was, {:.1f} mm deep",
                               news.time, news.needle.output.depth)
                 : fmt::format("Recording, {:.0f} s: {:.1f} mm deep, {:.1f} N", news.time, news.needle.output.depth,
                               news.needle.output.requested.force.norm());
    case Phase::finishing:
      return "The session is being saved and judged.";
    case Phase::finished:
      return news.result ? news.result->headline : std::string();
    case Phase::failed:
      return news.error;
  }
  return {};
}

bool TrackedAttempt::is_over(const StationUpdate& news) {
  return news.phase == StationUpdate::Phase::finished || news.phase == StationUpdate::Phase::failed;
}

}  // namespace bodkin::app
