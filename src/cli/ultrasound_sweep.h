#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/ultrasound_options.h"
#include "core/progress.h"
#include "imaging/ultrasound_screen/sweep.h"

namespace bodkin::cli {

// A moving probe, from the command line.
struct SweepOptions {
  std::string file;                // of poses; empty: none
  std::string to;                  // final position of the face; empty: no motion
  std::string tilt, rock, rotate;  // "from,to" in degrees; empty: none
  bool on_skin = false;
  std::int64_t frames = 60;
  double rate = 25.0;
  Argument frames_given, rate_given;

  // Some motion is given.
  bool any() const { return !file.empty() || !to.empty() || !tilt.empty() || !rock.empty() || !rotate.empty(); }
};

void add_sweep_options(CLI::App& command, SweepOptions& options);

// The form of a sweep's output, by the name of its file.
enum class SweepKind : std::uint8_t { sequence, video, pictures };
struct SweepTarget {
  SweepKind kind = SweepKind::sequence;
  std::string file;  // with "%04d" or similar if `kind` is pictures
};
// Throws InputError if no sweep can be written under the name, SystemError if a video needs ffmpeg and it is absent.
SweepTarget sweep_target(const std::string& output);

// The poses of a file (rows of t and 12 numbers) or of a motion from `first`. Throws InputError.
std::vector<imaging::SweepPose> read_sweep(const std::string& file);
imaging::SweepMotion motion_of(const SweepOptions& options);

// The contents of a sweep's images.
struct SweepScene {
  const anatomy::Case* patient = nullptr;
  const station::UltrasoundChoice* choice = nullptr;
  std::vector<imaging::SweepPose> poses;
  std::optional<imaging::NeedleInUltrasound> needle;
  std::string needle_words;
  bool plain = false;  // only the pixels
  bool ct = false;     // the same plane of the CT beside them; not in a sequence
  double rate = 25.0;  // images a second of a video
};

// The result.
struct SweepMade {
  std::vector<std::string> files;
  std::size_t black = 0;  // frames without an image
  std::string why;        // reason for the first of them
};

SweepMade write_sweep(const SweepScene& scene, imaging::Ultrasound& machine, const SweepTarget& target,
                      const Progress& progress);

}  // namespace bodkin::cli
