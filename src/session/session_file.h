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

// The meaning of a tissue id in a recording.
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

// The header of a session; written once at its start.
struct SessionHeader {
  std::string bodkin_version;
  std::string case_folder;        // absolute path at recording time
  std::string case_digest;        // of case.xml and its volumes
  std::string case_parts;         // of case_parts(); "": of an older session
  std::string case_xml;           // the description at recording time
  std::string operator_name;      // "expert", "novice", or the script's name
  std::string operator_settings;  // JSON: every parameter of the operator
  std::uint64_t seed = 0;
  double dt = 0.001;                                   // s
  std::string started_at;                              // ISO 8601, UTC
  std::string recording_id;                            // unique to this recording; "": of an older session
  anatomy::NeedlePath path;                            // given to the operator
  anatomy::HapticSettings haptics;                     // in use: those of the case, or replacements
  std::optional<anatomy::DeviceLimits> device;         // of the device in use, instead of the case's
  std::optional<SecondHeader> second;                  // a second hand, if any
  std::optional<anatomy::UltrasoundProbe> ultrasound;  // of the machine, if any
  std::string moving_body;  // JSON: of a body with motion of its own (--body moving); "": it was static
  std::vector<anatomy::NeedlePath> left_needles;  // left in the body earlier, from entry to tip
  std::string body_digest;                        // of the prepared deformable body; "": none
  std::string body_points;                        // as body_digest, only of its contact points; "": none, or older
  std::vector<TissueName> tissues;                // of the case's library, in the order of their ids
  std::vector<RecordedDiagnostic> diagnostics;    // in the order of TickOutput::diagnostics, at most most_diagnostics
  RecordedVolumes volumes;                        // of the patient; none in a session older than version 5
};

// An event with its place in the session.
struct SessionEvent {
  std::uint64_t tick = 0;
  forces::Event event{};
};

// Records a session to one SQLite file (write-ahead log) while it runs. append() is called by one thread only and may
// block on the disk: a servo thread passes its records through a ring, see session/recorder.h.
class SessionWriter {
 public:
  // Creates the file; throws InputError when it exists and `overwrite` is false, SystemError when it cannot be
  // created. In that case no file is left, and an existing one is unchanged.
  SessionWriter(const std::filesystem::path& file, const SessionHeader& header, bool overwrite);
  ~SessionWriter();
  SessionWriter(SessionWriter&&) noexcept;
  SessionWriter& operator=(SessionWriter&&) noexcept;

  void append(const simulation::TickRecord& record);
  // A sample of the second hand named in the header; times must ascend strictly.
  void append(const SecondSample& sample);
  // A sample of the ultrasound machine named in the header; times must ascend strictly.
  void append(const ScanSample& sample);
  void append(const ScannedPart& part);
  // A step of the moving body named in the header; in their order.
  void append(const fem::BodyStep& step);
  void append(const AppliedBodyStep& applied);
  // Ticks of changes must ascend strictly. Writes everything appended so far at once.
  void append(const NumberChange& change);
  // Makes everything appended so far durable on disk.
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
  // Version of the file's format. Version 2 has no diagnostics, and its loss_of_resistance is the force model's;
  // version 3 has no record of an ultrasound machine, version 4 no volumes of the patient.
  int version = 5;
  std::vector<simulation::TickRecord> ticks;  // events are in `events`, not in the records
  std::vector<SessionEvent> events;
  std::vector<SecondSample> second;                 // of the second hand
  std::vector<ScanSample> scans;                    // of the ultrasound machine: each is valid until the next one
  std::vector<ScannedPart> scanned;                 // shown in its images, in the order of their times
  std::vector<fem::BodyStep> body_steps;            // of a body with motion of its own; a step may be missing
  std::vector<AppliedBodyStep> applied_body_steps;  // which of them the needle met
  std::vector<NumberChange> changes;                // of the force models' numbers during the session
  std::optional<SessionTimings> timings;            // of a finished real-time session
  bool finished = false;                            // false: the recording process died; this is the saved part
};

// Throws InputError for anything that is not a valid session file of a known version.
Session read_session(const std::filesystem::path& file);

}  // namespace bodkin::session
