#include "scene/volume_job.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <utility>

#include "scene/volume_painter.h"

#include "core/error.h"

namespace bodkin::scene {

struct VolumeJob::Shared {
  mutable std::mutex mutex;  // guards what follows
  std::condition_variable_any changed;
  Status status;
  std::shared_ptr<const imaging::PreparedVolume> volume;
  std::optional<VolumeRequest> wanted;
  std::shared_ptr<const VolumeResult> newest;
  std::atomic<bool> another_is_wanted{false};
};

VolumeJob::VolumeJob(std::shared_ptr<const anatomy::Case> patient, int threads)
    : shared_(std::make_shared<Shared>()) {
  thread_ = std::jthread([shared = shared_, patient = std::move(patient),
                          threads](const std::stop_token& stop) mutable {
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
      shared->status = {1.0, false, failure.what(), {}, {}};
      return;
    }
    VolumePainter painter(shared->volume, threads);
    while (!stop.stop_requested()) {
      VolumeRequest request;
      {
        std::unique_lock lock(shared->mutex);
        if (!shared->changed.wait(lock, stop, [&] { return shared->wanted.has_value(); })) return;
        request = *std::exchange(shared->wanted, std::nullopt);
        shared->another_is_wanted = false;
      }
      auto result = std::make_shared<VolumeResult>();
      const bool finished = painter.draw(
          request, [&] { return stop.stop_requested() || (request.may_be_cut_short && shared->another_is_wanted); },
          *result);
      const std::scoped_lock lock(shared->mutex);
      if (finished) shared->newest = std::move(result);
      shared->status.busy = shared->wanted.has_value();
      shared->status.card = painter.card();
      shared->status.refusal = painter.refusal();
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

void VolumeJob::request(const VolumeRequest& request) {
  {
    const std::scoped_lock lock(shared_->mutex);
    shared_->wanted = request;
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
