#include "scene/surface_job.h"

#include <exception>
#include <mutex>
#include <utility>

#include "scene/sections.h"
#include "scene/surface_cache.h"

#include "core/error.h"

namespace bodkin::scene {

struct SurfaceJob::Shared {
  mutable std::mutex mutex;  // guards what follows
  Status status;
  std::shared_ptr<const PatientSurfaces> surfaces;
};

SurfaceJob::SurfaceJob(std::shared_ptr<const anatomy::Case> patient, std::filesystem::path folder)
    : shared_(std::make_shared<Shared>()) {
  thread_ = std::jthread(
      [shared = shared_, patient = std::move(patient), folder = std::move(folder)](const std::stop_token& stop) {
        std::shared_ptr<const PatientSurfaces> surfaces;
        std::string error;
        try {
          PatientSurfaces made = surfaces_of_case(patient->tissues, folder, [&](std::string_view, double fraction) {
            if (stop.stop_requested()) throw SystemError("surfaces: cancelled");
            const std::scoped_lock lock(shared->mutex);
            shared->status.fraction = fraction;
          });
          find_sections(patient->structures, patient->description.structures, made);
          surfaces = std::make_shared<const PatientSurfaces>(std::move(made));
        } catch (const std::exception& failure) {
          error = failure.what();
        }
        const std::scoped_lock lock(shared->mutex);
        shared->surfaces = std::move(surfaces);
        shared->status = {1.0, true, error};
      });
}

SurfaceJob::~SurfaceJob() = default;

SurfaceJob::Status SurfaceJob::status() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->status;
}

std::shared_ptr<const PatientSurfaces> SurfaceJob::surfaces() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->surfaces;
}

}  // namespace bodkin::scene
