#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "station/scan_thread.h"

#include "anatomy/case.h"
#include "imaging/ultrasound/scanned_parts.h"

namespace bodkin::station {

class HandSession;

// Records the pose and settings of the ultrasound machine in the session, at most a hundred times a second and only
// changes, and the parts of the patient that appear in its image. On the thread of the station.
class ScanLog {
 public:
  ScanLog(std::shared_ptr<const anatomy::Case> patient, const anatomy::UltrasoundProbe& probe);

  // The newest image, at this number of ticks of the session.
  void follow(const LiveImage& picture, std::uint64_t ticks, HandSession& session);

 private:
  void record_parts(const ScanSetup& now, double time, HandSession& session);

  std::shared_ptr<const anatomy::Case> patient_;
  imaging::ScannedSearch search_;
  imaging::ScannedParts seen_;
  std::optional<ScanSetup> last_;
  std::uint64_t picture_ = 0;
  double time_ = 0.0;  // s, of `last_`
};

}  // namespace bodkin::station
