// Untrusted recordings of poses: refused with a sentence, or poses that are finite and in order.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.h"
#include "io/pose_log.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace bodkin::io;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const bool is_xml : {false, true}) {
    try {
      const PoseLog log = is_xml ? parse_recorder_log(text, "x") : parse_sequence_poses(text, "x");
      for (const PoseTrack& track : log.tracks) {
        for (std::size_t i = 0; i < track.poses.size(); ++i) {
          if (!track.poses[i].pose.matrix().allFinite()) std::abort();
          if (i > 0 && !(track.poses[i].time > track.poses[i - 1].time)) std::abort();
        }
      }
      track_between(log, "NeedleTipToReference");
    } catch (const bodkin::InputError&) {
      continue;
    }
  }
  return 0;
}
