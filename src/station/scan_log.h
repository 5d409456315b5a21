#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "station/scan_thread.h"

#include "anatomy/case.h"
#include "imaging/ultrasound/scanned_parts.h"

namespace bodkin::station {

class HandSession;

// Writes into the session how the ultrasound machine was held and set, at most a hundred times a second and only what
// has changed, and which parts of the patient its picture showed. On the thread of the station.
class ScanLog {
 public:
  ScanLog(std::shared_ptr<const anatomy::Case> patient, const anatomy::UltrasoundProbe& probe);

  // The newest picture, when the session had so many ticks.
  void follow(const LivePicture& picture, std::uint64_t ticks, HandSession& session);

 private:
  void tell_parts(const ScanOrder& now, double time, HandSession& session);

  std::shared_ptr<const anatomy::Case> patient_;
  imaging::ScannedSearch search_;
  imaging::ScannedParts seen_;
  std::optional<ScanOrder> last_;
  std::uint64_t picture_ = 0;
  double time_ = 0.0;  // s, of `last_`
};

}  // namespace bodkin::station
