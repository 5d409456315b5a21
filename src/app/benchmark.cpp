#include "app/benchmark.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QThread>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <thread>

#include "app/main_window.h"
#include "app/pages/camera.h"
#include "app/pages/practise.h"
#include "app/pages/volume.h"
#include "tracking/footage_scene.h"
#include "tracking/jpeg_file.h"
#include <fmt/format.h>
#include <sys/resource.h>

#include "core/error.h"
#include "core/files.h"

namespace bodkin::app {

namespace {

constexpr double longest_wait = 120.0;           // s
constexpr double turn_of_frame = 0.02;           // rad
constexpr double lowest = 12.0, deepest = 20.0;  // mm, between which the needle moves
constexpr double least_dent = 0.5;               // mm, with which the skin is pressed
constexpr int camera_frames = 30, camera_quality = 85;
constexpr double kilobytes = 1024.0, bytes_of_gigabyte = 1e9;

// s of all threads of the process.
double process_time() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_gigabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * kilobytes / bytes_of_gigabyte;
}

double seconds_of(const QElapsedTimer& timer) {
  return 1e-9 * static_cast<double>(timer.nsecsElapsed());
}

void pass_moment() {
  QApplication::processEvents(QEventLoop::AllEvents, 5);
  QThread::usleep(200);
}

// Waits until the condition holds; returns s.
double wait_until(const std::string& what, const std::function<bool()>& holds) {
  QElapsedTimer timer;
  timer.start();
  while (!holds()) {
    if (seconds_of(timer) > longest_wait)
      throw SystemError(fmt::format("benchmark: {} did not come within {:.0f} s", what, longest_wait));
    pass_moment();
  }
  return seconds_of(timer);
}

struct FrameCost {
  double milliseconds = 0.0;  // of CPU a frame
  double rate = 0.0;          // frames/s
};

// Runs an action before each frame for some seconds.
FrameCost cost_of(MainWindow& window, double seconds, const std::function<void()>& each_frame) {
  int frames = 0;
  const QMetaObject::Connection counting =
      QObject::connect(&window.clock(), &FrameClock::frame, &window, [&frames] { ++frames; });
  QElapsedTimer timer;
  timer.start();
  const double before = process_time();
  int done = -1;
  while (seconds_of(timer) < seconds) {
    if (done != frames) each_frame();
    done = frames;
    pass_moment();
  }
  const double spent = process_time() - before, passed = seconds_of(timer);
  QObject::disconnect(counting);
  if (frames == 0) throw SystemError("benchmark: no frame was drawn");
  return {1e3 * spent / frames, frames / passed};
}

void add(std::vector<BenchmarkRow>& rows, const std::string& name, const FrameCost& cost, double most_ms,
         double least_rate) {
  rows.push_back({name, cost.milliseconds, "ms CPU a frame", most_ms, true});
  rows.push_back({name, cost.rate, "frames/s", least_rate, false});
}

void measure_needle(MainWindow& window, double seconds, std::vector<BenchmarkRow>& rows) {
  Practice& practice = window.practice();
  const auto push_until = [&](const std::string& what, const std::function<bool()>& holds) {
    std::uint64_t pushed_in = 0;
    wait_until(what, [&] {
      const std::uint64_t now = practice.frame().number;
      if (!holds() && now != pushed_in) practice.push(1.0, true);
      pushed_in = now;
      return holds();
    });
  };
  push_until("the skin", [&] { return practice.frame().dimple.depth > least_dent; });
  bool deeper = true;
  add(rows, "needle presses and leaves the skin, which dents",
      cost_of(window, seconds,
              [&] {
                practice.push(deeper ? 0.5 : -0.5, true);  // never through the skin
                deeper = !deeper;
              }),
      17.0, 60.0);
  push_until("the tissue", [&] { return practice.frame().depth > lowest; });
  const auto move = [&, direction = 1.0]() mutable {
    if (practice.frame().depth > deepest) direction = -1.0;
    if (practice.frame().depth < lowest) direction = 1.0;
    practice.push(direction, true);
  };
  add(rows, "needle moves in tissue", cost_of(window, seconds, move), 10.0, 60.0);
  window.run(Command::toggle_volume);
  const VolumeView& volume = window.practise_page().volume();
  wait_until("the volume beside the slices", [&] { return volume.volume() != nullptr && volume.is_settled(); });
  rows.push_back({"needle moves before the volume", cost_of(window, seconds, move).rate, "frames/s", 25.0, false});
  window.run(Command::toggle_volume);
}

void measure_camera(MainWindow& window, double seconds, std::vector<BenchmarkRow>& rows) {
  View3d& view = window.practise_page().view3d();
  add(rows, "camera turns",
      cost_of(window, seconds, [&] { view.set_camera(scene::turned(view.camera(), turn_of_frame, 0.0)); }), 40.0,
      25.0);
  rows.push_back({"full detail after it has turned",
                  wait_until("full detail", [&] { return view.scene()->layers().detail() > 1; }), "s", 0.5, true});
}

// Percentage of late ticks in some seconds.
double late_share(MainWindow& window, double seconds, bool drawing) {
  const auto counts = [&] {
    const std::uint64_t number = window.practice().frame().number;
    wait_until("a frame", [&] { return window.practice().frame().number > number + 1; });
    return std::pair{window.practice().frame().ticks, window.practice().frame().late_ticks};
  };
  const auto [ticks, late] = counts();
  if (drawing) {
    View3d& view = window.practise_page().view3d();
    cost_of(window, seconds, [&] { view.set_camera(scene::turned(view.camera(), turn_of_frame, 0.0)); });
  } else {
    window.clock().stop();
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    window.clock().start();
  }
  const auto [ticks_after, late_after] = counts();
  return 100.0 * static_cast<double>(late_after - late) / std::max(1.0, static_cast<double>(ticks_after - ticks));
}

void measure_volume(MainWindow& window, double seconds, std::vector<BenchmarkRow>& rows) {
  window.show_page(PageId::volume);
  auto* const page = window.findChild<VolumePage*>();
  if (page == nullptr) throw SystemError("benchmark: the window has no page for the volume");
  VolumeView& view = page->view();
  wait_until("the volume", [&] { return view.volume() != nullptr && view.is_settled(); });
  std::shared_ptr<const scene::VolumeResult> last = view.picture().base();
  int pictures = 0;
  const FrameCost cost = cost_of(window, seconds, [&] {
    view.set_camera(scene::turned(view.camera(), turn_of_frame, 0.0));
    pictures += view.picture().base() != last ? 1 : 0;
    last = view.picture().base();
  });
  static_cast<void>(cost);
  rows.push_back({"volume turns", pictures / seconds, "pictures/s", 25.0, false});
  rows.push_back({"volume in full after it has turned",
                  wait_until("the volume in full", [&] { return view.is_settled(); }), "s", 0.5, true});
  window.show_page(PageId::practise);
}

// Images of a mannequin, a needle and a probe, all moving, as sent by a camera: compressed, 30 per second.
std::filesystem::path camera_pictures(const std::filesystem::path& folder) {
  tracking::SceneOptions options;
  options.frames = camera_frames;
  options.look.samples = 2;
  const tracking::Footage rendered = tracking::render_scene(folder / "rendered", options);
  std::filesystem::create_directory(folder / "camera");
  for (const char* file : {"camera.json", "bodies.json"})
    std::filesystem::copy_file(rendered.folder / file, folder / "camera" / file);
  for (std::size_t i = 0; i < rendered.frames.size(); ++i) {
    const imaging::ImageRgb picture = tracking::read_picture(rendered.folder / rendered.frames[i].file);
    write_file(folder / "camera" / fmt::format("{:03}.jpg", i), tracking::encode_jpeg(picture, camera_quality));
  }
  return folder / "camera";
}

// Time from an image's arrival on the page of augmented reality until it is painted.
void measure_augmented_reality(MainWindow& window, double seconds, std::vector<BenchmarkRow>& rows) {
  const QTemporaryDir folder;
  if (!folder.isValid()) throw SystemError("benchmark: no folder for the camera's pictures can be made");
  const std::filesystem::path pictures = camera_pictures(folder.path().toStdString());
  window.show_page(PageId::camera);
  auto* const page = window.findChild<CameraPage*>();
  if (page == nullptr) throw SystemError("benchmark: the window has no page for a camera");
  page->show_source(pictures);
  wait_until("the camera's picture", [&] {
    if (!page->camera_status().error.empty()) throw SystemError("benchmark: " + page->camera_status().error);
    return !page->latencies().empty();
  });
  QElapsedTimer timer;
  timer.start();
  const std::uint64_t before = page->camera_status().number;
  page->forget_latencies();
  while (seconds_of(timer) < seconds || page->latencies().empty()) pass_moment();
  const double passed = seconds_of(timer);
  std::vector<double> latencies(page->latencies().begin(), page->latencies().end());
  const auto pictures_shown = static_cast<double>(page->camera_status().number - before);
  page->stop();
  std::sort(latencies.begin(), latencies.end());
  const auto at = [&](double share) {
    return 1e3 * latencies[static_cast<std::size_t>(share * static_cast<double>(latencies.size() - 1))];
  };
  rows.push_back({"camera's picture from arrival to painted, median", at(0.5), "ms", 60.0, true});
  rows.push_back({"the same of 95 % of the pictures", at(0.95), "ms", 90.0, true});
  rows.push_back({"camera's pictures drawn", pictures_shown / passed, "pictures/s", 20.0, false});
  window.show_page(PageId::practise);
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  }
  return "unknown processor";
}

}  // namespace

std::vector<BenchmarkRow> measure_window(MainWindow& window, double seconds) {
  std::vector<BenchmarkRow> rows;
  Practice& practice = window.practice();
  QElapsedTimer opening;
  opening.start();
  practice.choose_built_in();
  wait_until("the patient", [&] {
    if (!practice.failure().empty()) throw SystemError("benchmark: " + practice.failure());
    return window.practise_page().view3d().is_ready();
  });
  const double opened = seconds_of(opening);
  wait_until("the needle", [&] { return practice.state() == State::ready || practice.state() == State::aiming; });
  rows.push_back({"patient to first picture in 3-D", opened, "s", 8.0, true});
  measure_needle(window, seconds, rows);
  measure_camera(window, seconds, rows);
  const double without = late_share(window, seconds, false), with = late_share(window, seconds, true);
  rows.push_back(
      {"late ticks with the window, above those without", std::max(0.0, with - without), "% points", 0.5, true});
  measure_volume(window, seconds, rows);
  measure_augmented_reality(window, seconds, rows);
  rows.push_back({"memory at most", peak_gigabytes(), "GB", 2.5, true});
  return rows;
}

std::string benchmark_table(const std::vector<BenchmarkRow>& rows, const MainWindow& window) {
  std::string text = fmt::format("bodkin-app {} on {}, {} threads, window {}x{}\n", BODKIN_VERSION, processor(),
                                 std::thread::hardware_concurrency(), window.width(), window.height());
  for (const BenchmarkRow& row : rows) {
    text += fmt::format("{:<50} {:>8.2f} {:<15} wanted {} {:<5g} {}\n", row.name, row.value, row.unit,
                        row.at_most ? "at most " : "at least", row.wanted, row.is_reached() ? "reached" : "missed");
  }
  return text;
}

}  // namespace bodkin::app
