#include "cli/ultrasound_live.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "desktop/scan_window.h"
#include "station/live_scan.h"
#include <fmt/format.h>

#include "core/error.h"
#include "core/files.h"
#include "imaging/ultrasound_screen/machine_picture.h"

namespace bodkin::cli {

namespace {

using ScanClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds scan_interval{16};

double scan_seconds_since(ScanClock::time_point begin) {
  return std::chrono::duration<double>(ScanClock::now() - begin).count();
}

// The first name of its kind that no file has yet.
std::string free_name(const std::string& base) {
  for (int number = 1;; ++number) {
    std::string name = fmt::format("{}-{}.png", base, number);
    if (!std::filesystem::exists(name)) return name;
  }
}

std::string save_picture(const station::LiveScan& scan, const anatomy::Case& patient, imaging::MarkSide mark,
                         const std::string& base) {
  imaging::MachinePicture picture;
  picture.moment = scan.screen().moment();
  picture.mark = mark;
  picture.patient = patient.description.name;
  picture.calipers = scan.screen().calipers();
  picture.markers = scan.screen().markers();
  std::vector<Vec3> needle;
  if (const std::optional<imaging::NeedleInSound> in = scan.needle()) {
    needle = {patient.description.procedure.path->entry, in->pose.translation()};
  }
  picture.ct = imaging::ct_panel(patient, picture.moment, mark, needle);
  std::string name = free_name(base);
  write_file(name, imaging::machine_picture(picture, patient.library).png(1.0));
  return name;
}

// What the newest picture depends on.
struct Shown {
  Eigen::Matrix4d pose = Eigen::Matrix4d::Zero();  // no pose at all: nothing is shown yet
  imaging::UltrasoundSettings settings;
  double needle = -1.0;  // mm beyond its entry

  bool same(const Shown& other) const {
    return pose == other.pose && settings == other.settings && needle == other.needle;
  }
};

}  // namespace

void require_window() {
  const std::string obstacle = desktop::SdlScreen::obstacle();
  if (!obstacle.empty()) throw InputError(obstacle);
}

std::vector<std::string> scan_live(const anatomy::Case& patient, const station::UltrasoundChoice& choice,
                                   const imaging::ProbeOnSkin& hand,
                                   const std::optional<imaging::NeedleInSound>& needle, imaging::Ultrasound& machine,
                                   const std::string& base) {
  desktop::ScanWindow window(patient, choice.mark);
  station::LiveScan scan(patient, choice, hand, needle, desktop::ScanWindow::machine_place());
  std::vector<std::string> saved;
  desktop::ScanPace pace;
  Shown shown;
  auto before = ScanClock::now();
  while (!scan.ended()) {
    const auto begin = ScanClock::now();
    station::ScreenEvent event;
    while (window.next(event)) scan.take(event);
    const double passed = scan_seconds_since(before);
    before = begin;
    scan.advance(passed);
    if (passed > 0.0) pace.frames += 0.1 * (1.0 / passed - pace.frames);

    const std::optional<imaging::NeedleInSound> in = scan.needle();
    const Pose pose = scan.pose();
    const Shown next{pose.matrix(), scan.settings(), scan.needle_depth()};
    if (!scan.screen().frozen() && !shown.same(next)) {
      try {
        machine.set(scan.settings());
      } catch (const InputError& refused) {
        scan.say(refused.what());
      }
      const auto start = ScanClock::now();
      const imaging::UltrasoundFrame& frame = machine.image(pose, in);
      pace.picture = 1000.0 * scan_seconds_since(start);
      scan.screen().take({frame, pose, choice.probe, machine.settings(), scan.needle_words()});
      shown = next;
    }
    if (scan.take_save() && !scan.screen().empty()) {
      try {
        saved.push_back(save_picture(scan, patient, choice.mark, base));
        scan.say("Saved " + saved.back());
      } catch (const std::exception& failed) {  // a full disk ends no scan
        scan.say(failed.what());
      }
    }
    window.draw(scan, pace);
    std::this_thread::sleep_until(begin + scan_interval);
  }
  return saved;
}

}  // namespace bodkin::cli
