#include "app/models/scan_model.h"

#include <atomic>
#include <mutex>
#include <utility>

#include "io/case_folder.h"

namespace bodkin::app {

struct Scanner::Shared {
  std::mutex mutex;  // guards `came`
  std::vector<imaging::ScanSlice> came;
  std::atomic<int> taken{0}, ordered{0};
  std::atomic<bool> running{false};
};

Scanner::Scanner() : shared_(std::make_shared<Shared>()) {}

Scanner::~Scanner() = default;

void Scanner::start(std::shared_ptr<const OpenCase> patient, const imaging::ScanProtocol& protocol,
                    const std::optional<imaging::ScannedNeedle>& needle) {
  thread_ = {};  // ends the one before
  shared_ = std::make_shared<Shared>();
  shared_->running = true;
  shared_->ordered = static_cast<int>(imaging::slice_positions(protocol).size());
  thread_ =
      std::jthread([shared = shared_, patient = std::move(patient), protocol, needle](const std::stop_token& stop) {
        const imaging::SlicePlane plane = imaging::scan_plane(patient->patient.ct.grid);
        for (const double z : imaging::slice_positions(protocol)) {
          if (stop.stop_requested()) break;
          imaging::ScanSlice slice = imaging::take_slice(patient->patient.ct, plane, protocol, z, needle);
          const std::scoped_lock lock(shared->mutex);
          shared->came.push_back(std::move(slice));
          ++shared->taken;
        }
        shared->running = false;
      });
}

void Scanner::cancel() {
  thread_.request_stop();
}

bool Scanner::running() const {
  return shared_->running;
}

double Scanner::fraction() const {
  const int ordered = shared_->ordered;
  return ordered > 0 ? static_cast<double>(shared_->taken) / ordered : 0.0;
}

int Scanner::collect(imaging::CtScan& scan) {
  const std::scoped_lock lock(shared_->mutex);
  const int count = static_cast<int>(shared_->came.size());
  for (imaging::ScanSlice& slice : shared_->came) scan.slices.push_back(std::move(slice));
  shared_->came.clear();
  return count;
}

std::optional<anatomy::NeedlePath> path_to(const OpenCase& patient, const Vec3& target) {
  const anatomy::TissueVolume& tissues = patient.patient.tissues;
  const auto is_body = [&](const Vec3& point) {
    return anatomy::nearest(tissues, point, anatomy::tissue::air) != anatomy::tissue::air;
  };
  if (!is_body(target)) return std::nullopt;
  if (const auto& path = patient.description().procedure.path) {
    if ((path->entry - target).norm() > 1.0) return anatomy::NeedlePath{path->entry, target};
  }
  constexpr double step = 0.5, farthest = 400.0, of_air = 10.0;  // mm; bowel gas is not the outside
  std::optional<anatomy::NeedlePath> nearest;
  for (const Vec3& outwards : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, 0, 0), Vec3(-1, 0, 0)}) {
    double air = 0.0;
    for (double way = step; way < farthest && air < of_air; way += step) {
      air = is_body(target + way * outwards) ? 0.0 : air + step;
      if (air < of_air) continue;
      const double length = way - of_air;
      if (!nearest || length < nearest->length()) nearest = {Vec3(target + length * outwards), target};
    }
  }
  return nearest;
}

void save_plan(const OpenCase& patient, const anatomy::NeedlePath& path) {
  anatomy::CaseDescription description = patient.description();
  description.procedure.path = path;
  description.procedure.target_tissue.clear();
  io::write_case_description(description, patient.folder);
}

}  // namespace bodkin::app
