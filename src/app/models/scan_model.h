#pragma once

#include <memory>
#include <optional>
#include <thread>

#include "views/open_case.h"

#include "imaging/ct_scan.h"

namespace bodkin::app {

using namespace views;

// Computes the slices of a scan one by one on a separate thread. Calls from one thread.
class Scanner {
 public:
  Scanner();
  // Cancels, and waits for the slice in progress.
  ~Scanner();
  Scanner(const Scanner&) = delete;
  Scanner& operator=(const Scanner&) = delete;

  // `protocol` must be valid, the patient must have a CT. Cancels a scan in progress.
  void start(std::shared_ptr<const OpenCase> patient, const imaging::ScanProtocol& protocol,
             const std::optional<imaging::ScannedNeedle>& needle);
  // Keeps the completed slices.
  void cancel();
  bool running() const;
  // Share of the requested slices, 0 to 1.
  double fraction() const;
  // Appends the slices completed since the last call, in order. Returns their number.
  int collect(imaging::CtScan& scan);

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

// The path to a new target: from the entry of the case, or else straight from the nearest skin in front, behind or at
// the side. Empty if the target is outside the body.
std::optional<anatomy::NeedlePath> path_to(const OpenCase& patient, const Vec3& target);

// Makes `path` the plan of the case, with the point as its target instead of the entry of a tissue, and writes it to
// the case's folder. Throws InputError and SystemError, see write_case_description().
void save_plan(const OpenCase& patient, const anatomy::NeedlePath& path);

}  // namespace bodkin::app
