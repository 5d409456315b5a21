#pragma once

#include <memory>
#include <optional>
#include <thread>

#include "views/open_case.h"

#include "imaging/ct_scan.h"

namespace bodkin::app {

using namespace views;

// Takes the slices of a scan one by one on a thread of its own. One thread calls.
class Scanner {
 public:
  Scanner();
  // Cancels, and waits for the slice that is being taken.
  ~Scanner();
  Scanner(const Scanner&) = delete;
  Scanner& operator=(const Scanner&) = delete;

  // `protocol` must be without trouble, the patient must have a CT. A scan that runs is cancelled.
  void start(std::shared_ptr<const OpenCase> patient, const imaging::ScanProtocol& protocol,
             const std::optional<imaging::ScannedNeedle>& needle);
  // The slices that came remain.
  void cancel();
  bool running() const;
  // Of the slices that were ordered, 0 to 1.
  double fraction() const;
  // Appends the slices that came since the last call, in their order. Returns how many.
  int collect(imaging::CtScan& scan);

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;
  std::jthread thread_;
};

// The path to a new target: from the entry that the case has, or else straight from the nearest skin in front, behind
// or beside it. Nothing where the target lies outside the body.
std::optional<anatomy::NeedlePath> path_to(const OpenCase& patient, const Vec3& target);

// Makes `path` the plan of the case, whose aim is then the point, no longer the entry of a tissue, and writes it to
// the case's folder. Throws InputError and SystemError, see write_case_description().
void save_plan(const OpenCase& patient, const anatomy::NeedlePath& path);

}  // namespace bodkin::app
