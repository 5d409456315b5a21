#include "scene/volume_job.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

#include "core/error.h"

namespace bodkin::scene {

imaging::VolumeCamera volume_camera(const Projection& projection) {
  imaging::VolumeCamera camera;
  const Mat3& axes = projection.axes();
  camera.eye = projection.camera().eye;
  camera.width = projection.width();
  camera.height = projection.height();
  camera.right = axes.col(0) / projection.focal_length();
  camera.down = axes.col(1) / projection.focal_length();
  camera.first = axes.col(2) + (0.5 - 0.5 * camera.width) * camera.right + (0.5 - 0.5 * camera.height) * camera.down;
  return camera;
}

struct VolumeJob::Shared {
  mutable std::mutex mutex;  // guards what follows
  std::condition_variable_any changed;
  Status status;
  std::shared_ptr<const imaging::PreparedVolume> volume;
  std::optional<VolumeOrder> wanted;
  std::shared_ptr<const VolumeResult> newest;
  std::atomic<bool> another_is_wanted{false};
};

namespace {

void draw_volume(const std::shared_ptr<const imaging::PreparedVolume>& volume, const VolumeOrder& order,
                 ThreadPool& pool, const std::function<bool()>& cancelled, VolumeResult& result, bool& finished) {
  const auto begin = std::chrono::steady_clock::now();
  result.order = order;
  result.caster =
      std::make_shared<const imaging::RayCaster>(volume, order.look, imaging::step_of(*volume, order.voxels));
  finished = result.caster->draw(volume_camera(Projection(order.camera, order.width, order.height)), pool,
                                 result.pixels, cancelled);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

VolumeJob::VolumeJob(std::shared_ptr<const anatomy::Case> patient, int threads)
    : shared_(std::make_shared<Shared>()) {
  thread_ =
      std::jthread([shared = shared_, patient = std::move(patient), threads](const std::stop_token& stop) mutable {
        try {
          auto made = std::make_shared<const imaging::PreparedVolume>(
              imaging::prepare_volume(patient->ct, patient->tissues, patient->library, std::size_t{1} << 25U,
                                      [&](std::string_view, double fraction) {
                                        if (stop.stop_requested()) throw SystemError("volume: cancelled");
                                        const std::scoped_lock lock(shared->mutex);
                                        shared->status.fraction = fraction;
                                      }));
          patient.reset();
          const std::scoped_lock lock(shared->mutex);
          shared->volume = std::move(made);
          shared->status.busy = shared->wanted.has_value();
        } catch (const std::exception& failure) {
          const std::scoped_lock lock(shared->mutex);
          shared->status = {1.0, false, failure.what()};
          return;
        }
        ThreadPool pool(threads);
        while (!stop.stop_requested()) {
          VolumeOrder order;
          {
            std::unique_lock lock(shared->mutex);
            if (!shared->changed.wait(lock, stop, [&] { return shared->wanted.has_value(); })) return;
            order = *std::exchange(shared->wanted, std::nullopt);
            shared->another_is_wanted = false;
          }
          auto result = std::make_shared<VolumeResult>();
          bool finished = false;
          draw_volume(
              shared->volume, order, pool,
              [&] { return stop.stop_requested() || (order.may_be_cut_short && shared->another_is_wanted); }, *result,
              finished);
          const std::scoped_lock lock(shared->mutex);
          if (finished) shared->newest = std::move(result);
          shared->status.busy = shared->wanted.has_value();
        }
      });
}

VolumeJob::~VolumeJob() = default;

VolumeJob::Status VolumeJob::status() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->status;
}

std::shared_ptr<const imaging::PreparedVolume> VolumeJob::volume() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->volume;
}

void VolumeJob::order(const VolumeOrder& order) {
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->wanted = order;
    shared_->another_is_wanted = true;
    shared_->status.busy = true;
  }
  shared_->changed.notify_one();
}

std::shared_ptr<const VolumeResult> VolumeJob::newest() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->newest;
}

}  // namespace bodkin::scene
