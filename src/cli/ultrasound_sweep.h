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

// A probe in motion as the command line gives it.
struct SweepOptions {
  std::string file;                // of poses; empty: none
  std::string to;                  // where the face ends; empty: stays
  std::string tilt, rock, rotate;  // "from,to" in degrees; empty: none
  bool on_skin = false;
  std::int64_t frames = 60;
  double rate = 25.0;
  Argument frames_given, rate_given;

  // Some motion was asked for.
  bool any() const { return !file.empty() || !to.empty() || !tilt.empty() || !rock.empty() || !rotate.empty(); }
};

void add_sweep_options(CLI::App& command, SweepOptions& options);

// What a sweep becomes, by the name of its file.
enum class SweepKind : std::uint8_t { sequence, video, pictures };
struct SweepTarget {
  SweepKind kind = SweepKind::sequence;
  std::string file;  // with "%04d" or the like where `kind` is pictures
};
// Throws InputError when no sweep can be written under the name, SystemError when a video needs ffmpeg and it is
// absent.
SweepTarget sweep_target(const std::string& output);

// The poses of a file (rows of t and 12 numbers) or of a motion from `first`. Throws InputError.
std::vector<imaging::SweepPose> read_sweep(const std::string& file);
imaging::SweepMotion motion_of(const SweepOptions& options);

// What a sweep shows.
struct SweepScene {
  const anatomy::Case* patient = nullptr;
  const station::UltrasoundChoice* choice = nullptr;
  std::vector<imaging::SweepPose> poses;
  std::optional<imaging::NeedleInSound> needle;
  std::string needle_words;
  bool plain = false;  // the pixels alone
  bool ct = false;     // the same plane of the CT beside them; not in a sequence
  double rate = 25.0;  // pictures a second of a video
};

// What was made.
struct SweepMade {
  std::vector<std::string> files;
  std::size_t black = 0;  // frames without a picture
  std::string why;        // of the first of them
};

SweepMade write_sweep(const SweepScene& scene, imaging::Ultrasound& machine, const SweepTarget& target,
                      const Progress& progress);

}  // namespace bodkin::cli
