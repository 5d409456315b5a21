#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "session/body_log.h"
#include "session/number_change.h"
#include "session/scan_sample.h"
#include "session/second_sample.h"
#include "session/session_timings.h"
#include "session/volume_table.h"

#include "anatomy/case.h"
#include "anatomy/ultrasound_probe.h"
#include "simulation/tick_record.h"

namespace bodkin::session {

// What a tissue id of a recording means.
struct TissueName {
  anatomy::TissueId id = anatomy::tissue::air;
  std::string name;   // "ligamentum_flavum"
  std::string title;  // "ligamentum flavum"
};

// A number that the force models published each tick; see forces/diagnostics.h.
struct RecordedDiagnostic {
  std::string name;   // "wall_mm"
  std::string title;  // "position of the wall"
};

// What a session is about; written once at its start.
struct SessionHeader {
  std::string bodkin_version;
  std::string case_folder;        // absolute path at recording time
  std::string case_digest;        // of case.xml and its volumes
  std::string case_parts;         // of case_parts(); "": of an older session
  std::string case_xml;           // the description as it was
  std::string operator_name;      // "expert", "novice", or the script's name
  std::string operator_settings;  // JSON: every parameter of the operator
  std::uint64_t seed = 0;
  double dt = 0.001;                                   // s
  std::string started_at;                              // ISO 8601, UTC
  std::string recording_id;                            // of this recording alone; "": of an older session
  anatomy::NeedlePath path;                            // that the operator was given
  anatomy::HapticSettings haptics;                     // that were used: those of the case, or others in their place
  std::optional<anatomy::DeviceLimits> device;         // that was held, in place of the case's
  std::optional<SecondHeader> second;                  // a second hand, where there was one
  std::optional<anatomy::UltrasoundProbe> ultrasound;  // of the machine, where there was one
  std::string moving_body;  // JSON: of a body that moved on its own time (--body moving); "": it was static
  std::vector<anatomy::NeedlePath> left_needles;  // in the body before, from entry to tip
  std::string body_digest;                        // of the deformable body as it was prepared; "": there was none
  std::string body_points;                        // the same of its contact points alone; "": none, or older
  std::vector<TissueName> tissues;                // of the case's library, in the order of their ids
  std::vector<RecordedDiagnostic> diagnostics;    // in the order of TickOutput::diagnostics, at most most_diagnostics
  RecordedVolumes volumes;                        // of the patient; none in a session of before version 5
};

// An event with its place in the session.
struct SessionEvent {
  std::uint64_t tick = 0;
  forces::Event event{};
};

// Records a session to one SQLite file (write-ahead log) while it runs. append() is called by one thread only and may
// block on the disk: a servo thread hands its records over through a ring, see session/recorder.h.
class SessionWriter {
 public:
  // Creates the file; throws InputError when it exists and `overwrite` is false, SystemError when it cannot be made.
  // Then no file is left, and one that was to be replaced is as it was.
  SessionWriter(const std::filesystem::path& file, const SessionHeader& header, bool overwrite);
  ~SessionWriter();
  SessionWriter(SessionWriter&&) noexcept;
  SessionWriter& operator=(SessionWriter&&) noexcept;

  void append(const simulation::TickRecord& record);
  // Of the second hand, which the header names; times rise strictly.
  void append(const SecondSample& sample);
  // Of the ultrasound machine, which the header names; times rise strictly.
  void append(const ScanSample& sample);
  void append(const ScannedPart& part);
  // Of a body that moves by itself, which the header names; in their order.
  void append(const fem::BodyStep& step);
  void append(const BodyTaken& taken);
  // Ticks of changes rise strictly. Writes at once what was appended.
  void append(const NumberChange& change);
  // Makes everything appended so far safe on disk.
  void commit();
  // Writes the closing entry: the session ended on purpose. Throws SystemError when the disk is full.
  void finish(const std::optional<SessionTimings>& timings = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// A whole session in memory.
struct Session {
  SessionHeader header;
  // Of the file's format. Version 2 has no diagnostics, and its loss_of_resistance is what the force model told;
  // version 3 does not know what an ultrasound machine did, version 4 keeps no volumes of the patient.
  int version = 5;
  std::vector<simulation::TickRecord> ticks;  // events stand in `events`, not in the records
  std::vector<SessionEvent> events;
  std::vector<SecondSample> second;       // of the second hand
  std::vector<ScanSample> scans;          // of the ultrasound machine: each holds until the next one
  std::vector<ScannedPart> scanned;       // what its picture showed, in the order of their times
  std::vector<fem::BodyStep> body_steps;  // of a body that moved by itself; a step may be missing
  std::vector<BodyTaken> body_taken;      // which of them the needle met
  std::vector<NumberChange> changes;      // of the force models' numbers while it ran
  std::optional<SessionTimings> timings;  // of a finished session that ran on the clock
  bool finished = false;                  // false: the recording process died; what is here is what was saved
};

// Throws InputError for anything that is not a valid session file of a known version.
Session read_session(const std::filesystem::path& file);

}  // namespace bodkin::session
