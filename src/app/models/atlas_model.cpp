#include "app/models/atlas_model.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <utility>

#include "app/models/practice_patients.h"
#include "scene/surface_cache.h"

namespace bodkin::app {

namespace {

constexpr double surface_spacing = 4.0;  // mm

struct AtlasCancelled : std::exception {};

}  // namespace

struct AtlasModel::Shared {
  mutable std::mutex lock;
  Status status;
  std::shared_ptr<const patient::Atlas> atlas;
  std::shared_ptr<const scene::PatientSurfaces> surfaces;

  Progress progress(std::stop_token stop, double from, double to) {
    return [this, stop = std::move(stop), from, to](std::string_view, double fraction) {
      if (stop.stop_requested()) throw AtlasCancelled();
      const std::lock_guard guard(lock);
      status.fraction = from + (to - from) * fraction;
    };
  }
  // Runs work and stores the reason of a failure.
  template <typename Work>
  void run(const Work& work) {
    std::string error;
    try {
      work();
    } catch (const AtlasCancelled&) {
      return;
    } catch (const std::exception& caught) {
      error = caught.what();
    }
    const std::lock_guard guard(lock);
    status.error = error;
    status.working = false;
  }
};

AtlasModel::AtlasModel(std::filesystem::path folder)
    : folder_(std::move(folder)), shared_(std::make_shared<Shared>()) {}

AtlasModel::~AtlasModel() = default;

AtlasModel::Status AtlasModel::status() const {
  const std::lock_guard guard(shared_->lock);
  return shared_->status;
}

std::shared_ptr<const patient::Atlas> AtlasModel::atlas() const {
  const std::lock_guard guard(shared_->lock);
  return shared_->atlas;
}

std::shared_ptr<const scene::PatientSurfaces> AtlasModel::surfaces() const {
  const std::lock_guard guard(shared_->lock);
  return shared_->surfaces;
}

void AtlasModel::prepare() {
  if (thread_.joinable()) return;
  shared_->status.working = true;
  thread_ = std::jthread([shared = shared_, folder = folder_ / "atlas"](const std::stop_token& stop) {
    shared->run([&] {
      auto atlas = std::make_shared<const patient::Atlas>(patient::BodyParameters{});
      {
        const std::lock_guard guard(shared->lock);
        shared->atlas = atlas;
      }
      const patient::BodyBlock whole{.middle = {}, .width = 0.0, .spacing = surface_spacing};
      const anatomy::TissueVolume tissues =
          patient::body_volume(atlas->shape(), atlas->tissues(), whole, shared->progress(stop, 0.1, 0.4));
      std::error_code ignored;  // a folder that cannot be created only costs time
      std::filesystem::create_directories(folder, ignored);
      auto surfaces = std::make_shared<const scene::PatientSurfaces>(
          scene::surfaces_of_case(tissues, folder, shared->progress(stop, 0.4, 1.0)));
      const std::lock_guard guard(shared->lock);
      shared->surfaces = std::move(surfaces);
    });
  });
}

void AtlasModel::make_case(const std::string& code) {
  const std::shared_ptr<const patient::Atlas> atlas = this->atlas();
  if (!atlas || status().working) return;
  if (thread_.joinable()) thread_.join();
  {
    const std::lock_guard guard(shared_->lock);
    shared_->status = {};
    shared_->status.working = true;
  }
  thread_ = std::jthread([shared = shared_, atlas, code, folder = folder_ / "patients"](const std::stop_token& stop) {
    shared->run([&] {
      std::filesystem::path made = needle_point_case(*atlas, code, folder, shared->progress(stop, 0.0, 1.0));
      const std::lock_guard guard(shared->lock);
      shared->status.made = std::move(made);
    });
  });
}

void PointQuiz::ask(const patient::Atlas& atlas) {
  const patient::AtlasPoint* const before = point_;
  std::uniform_int_distribution<std::size_t> any(0, atlas.points().size() - 1);
  do {
    point_ = &atlas.points()[any(random_)];
  } while (point_ == before);
  answered_ = false;
}

void PointQuiz::ask_again() {
  answered_ = false;
}

void PointQuiz::stop() {
  point_ = nullptr;
  answered_ = false;
}

void PointQuiz::answer(const Vec3& place) {
  if (!asked()) return;
  shown_ = place;
  miss_ = (place - point_->place).norm();
  if (point_->bilateral) miss_ = std::min(miss_, (place - point_->mirrored()).norm());
  answered_ = true;
  ++rounds_;
  sum_ += miss_;
  if (miss_ <= near) ++found_;
}

}  // namespace bodkin::app
