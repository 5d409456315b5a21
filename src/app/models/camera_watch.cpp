#include "app/models/camera_watch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <exception>
#include <utility>

#include "tracking/footage_scene.h"
#include "tracking/lens_watch.h"
#include "tracking/marker_watch.h"
#include "tracking/registration_file.h"
#include "tracking/tool_sightings.h"
#include <fmt/format.h>

#include "core/error.h"
#include "haptics/tick_clock.h"

namespace bodkin::app {

namespace {

using Clock = std::chrono::steady_clock;
using tracking::TrackingStatus;

constexpr std::chrono::milliseconds short_nap{5};

double since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

// Tracker and overlay of one camera.
class CameraWatch::Show {
 public:
  Show(const OpenCase& patient, const std::string& source, const tracking::OpenedFootage& opened,
       const std::filesystem::path& registration, const tracking::AugmentedLook& look)
      : place_(registration.empty() ? tracking::placed_at(patient.patient, tracking::scene_skin())
                                    : tracking::read_registration(registration).fixed_from_moving),
        tracker_(opened.camera, opened.bodies),
        view_(patient.patient, opened.camera, place_, look),
        markers_(source) {
    const auto& bodies = tracker_.bodies();
    const auto found =
        std::find_if(bodies.begin(), bodies.end(), [](const auto& body) { return body.name == "mannequin"; });
    if (found == bodies.end())
      throw InputError("no body is called \"mannequin\", in which the patient is placed; name one so in the bodies");
    mannequin_ = static_cast<std::size_t>(found - bodies.begin());
  }

  void set_look(const tracking::AugmentedLook& look) { view_.set_look(look); }
  void set_moved_tissue(std::shared_ptr<const imaging::TissueDisplacement> moved) { moved_ = std::move(moved); }
  // A session can follow the tools during a pass through the images, until it ends.
  void begin(const std::string& source) {
    sightings_ = std::make_shared<tracking::ToolSightings>(tracker_.bodies(), place_, true);
    tracking::announce(source, sightings_);
  }
  // Remarks about all images of this pass.
  void note(const std::string& sentence) { sightings_->note(sentence); }
  void end(const std::string& why) {
    if (sightings_ != nullptr) sightings_->end(why);
    sightings_.reset();
  }

  // Draws on the image, and reports the detections. `taken`: s of the system's clock, its time.
  void draw(tracking::SourcePicture& picture, double taken, CameraStatus& status) {
    const auto& poses = tracker_.track(picture.grey, picture.time);
    lens_.add(poses);
    markers_.add(tracker_, picture.grey);
    status.note = markers_.warning();
    if (status.note.empty()) status.note = lens_.warning();
    sightings_->warn(status.note);
    sightings_->publish(poses, taken, haptics::monotonic_seconds());
    const tracking::TrackedPose& mannequin = poses[mannequin_];
    std::vector<tracking::ShownBody> tools;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const tracking::MarkerBody& body = tracker_.bodies()[i];
      const tracking::TrackedPose& pose = poses[i];
      status.bodies.push_back({body.name, pose.status, std::sqrt(tracking::point_covariance(pose, body.tip).trace()),
                               pose.residual, pose.edge_ratio, pose.markers});
      if (i == mannequin_) continue;
      tools.push_back({&body, &pose});
      if (pose.status != TrackingStatus::ok || mannequin.status != TrackingStatus::ok) continue;
      const Pose tool = tracking::tool_in_patient(body, pose.camera_from_body, mannequin.camera_from_body, place_);
      if (body.name == "needle") status.needle = tool;
      if (body.name == "probe") status.probe = tool;
    }
    view_.draw(picture.colour, &mannequin, tools, moved_.get());
    status.large_oval = view_.is_large();
    if (view_.needle()) {
      status.tip = view_.needle()->tissue;
      status.tip_on_bone = view_.needle()->bone;
    }
  }

 private:
  tracking::Similarity place_;
  tracking::Tracker tracker_;
  tracking::AugmentedView view_;
  tracking::LensWatch lens_;
  tracking::MarkerWatch markers_;
  std::shared_ptr<tracking::ToolSightings> sightings_;
  std::shared_ptr<const imaging::TissueDisplacement> moved_;
  std::size_t mannequin_ = 0;
};

CameraWatch::CameraWatch(std::shared_ptr<const OpenCase> patient, const tracking::FootageFiles& files,
                         const std::filesystem::path& registration, const tracking::AugmentedLook& look,
                         std::function<void()> on_picture)
    : patient_(std::move(patient)),
      files_(files),
      registration_(registration),
      on_picture_(std::move(on_picture)),
      look_(look) {
  status_.stage = "opening the camera";
  thread_ = std::jthread([this](const std::stop_token& stop) {
    std::string error;
    try {
      run(stop);
    } catch (const std::exception& failure) {
      error = failure.what();
    }
    const std::lock_guard guard(lock_);
    status_.error = error;
    status_.stage.clear();
  });
}

CameraWatch::~CameraWatch() {
  thread_.request_stop();
  thread_.join();  // before what it uses goes
}

void CameraWatch::set_look(const tracking::AugmentedLook& look) {
  const std::lock_guard guard(lock_);
  look_ = look;
}

void CameraWatch::set_moved_tissue(std::shared_ptr<const imaging::TissueDisplacement> moved) {
  const std::lock_guard guard(lock_);
  moved_ = std::move(moved);
}

CameraStatus CameraWatch::status() const {
  const std::lock_guard guard(lock_);
  return status_;
}

void CameraWatch::run(const std::stop_token& stop) {
  std::optional<Show> show;
  if (tracking::has_calibration(files_)) {
    tracking::AugmentedLook look;
    {
      const std::lock_guard guard(lock_);
      look = *std::exchange(look_, std::nullopt);
    }
    show.emplace(*patient_, files_.source, tracking::open_footage_files(files_), registration_, look);
  }
  while (play(stop, show ? &*show : nullptr)) {
  }
}

bool CameraWatch::play(const std::stop_token& stop, Show* show) {
  if (show == nullptr) return show_pictures(stop, nullptr);
  show->begin(files_.source);
  try {
    const bool again = show_pictures(stop, show);
    show->end({});
    return again;
  } catch (const std::exception& failure) {
    show->end(failure.what());
    throw;
  }
}

bool CameraWatch::show_pictures(const std::stop_token& stop, Show* show) {
  // A camera can be open only once: the search for its calibration has closed it.
  const std::unique_ptr<tracking::PictureSource> source =
      show != nullptr ? tracking::open_footage_files(files_).source
                      : tracking::open_source(files_.source, {.rate = files_.rate, .locks = std::nullopt});
  const std::string known = tracking::sentence_of(source->notes());
  if (show != nullptr) show->note(known);
  std::optional<Clock::time_point> last;  // when the previous image was due
  double last_time = 0.0;
  std::deque<Clock::time_point> shown;
  while (!stop.stop_requested()) {
    if (paused_.load()) {
      std::this_thread::sleep_for(short_nap);
      continue;
    }
    std::optional<tracking::SourcePicture> picture = source->next();
    if (!picture) return !source->live() && last.has_value();
    const Clock::duration decoding = Clock::now() - picture->arrived;
    const double wait = last && !source->live() ? std::max(0.0, picture->time - last_time) : 0.0;
    while (last && !stop.stop_requested() && since(*last) < wait) std::this_thread::sleep_for(short_nap);
    last = Clock::now();
    last_time = picture->time;
    CameraStatus status;
    status.source_note = known;
    status.arrived = *last - decoding;  // of a video or a folder: when it would have come from a camera
    if (show != nullptr) {
      std::optional<tracking::AugmentedLook> look;
      {
        const std::lock_guard guard(lock_);
        look = std::exchange(look_, std::nullopt);
        show->set_moved_tissue(moved_);
      }
      if (look) show->set_look(*look);
      const double now = haptics::monotonic_seconds();
      show->draw(*picture, source->live() ? picture->time : now, status);
    } else {
      status.note =
          "This camera is not calibrated: its picture is shown alone. Calibrate it with 'bodkin camera calibrate'.";
    }
    shown.push_back(Clock::now());
    while (shown.front() + std::chrono::seconds(1) < shown.back()) shown.pop_front();
    status.time = picture->time;
    status.rate = static_cast<double>(shown.size());
    status.picture = std::make_shared<const imaging::ImageRgb>(std::move(picture->colour));
    {
      const std::lock_guard guard(lock_);
      status.number = status_.number + 1;
      status_ = std::move(status);
    }
    if (on_picture_) on_picture_();
  }
  return false;
}

}  // namespace bodkin::app
