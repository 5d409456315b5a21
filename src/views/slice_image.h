#pragma once

#include <QImage>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "scene/breath_motion.h"
#include "views/open_case.h"
#include "views/slice_sampling.h"

#include "imaging/tissue_displacement.h"

namespace bodkin::views {

// Parameters of a slice's pixels apart from the patient.
struct SliceLook {
  double window = 620.0;  // HU from black to white
  double level = 130.0;   // HU of the middle grey
  Slab slab;
  bool tints = true;    // of the tissues
  bool hatched = true;  // forbidden regions

  bool operator==(const SliceLook&) const = default;
};

// The usual windows for reading a CT; name, window and level in HU.
struct WindowPreset {
  const char* name;  // to be translated
  double window, level;
};
extern const std::array<WindowPreset, 6> window_presets;

// The image of a slice. Only changes are recomputed: another window needs no new samples, a needle that moves within
// the plane needs nothing.
class SliceImage {
 public:
  void set_case(std::shared_ptr<const OpenCase> patient);
  // `drawn_in`: inspiration, 0 to 1. `moved`: further displacement of the tissue; null: none.
  const QImage& picture(const imaging::SlicePlane& plane, const SliceLook& look, double drawn_in = 0.0,
                        std::shared_ptr<const imaging::TissueDisplacement> moved = nullptr);

  // LPS mm, position at rest of the tissue at `place` in the last image.
  Vec3 at_rest(const Vec3& place) const {
    return breath_.at_rest(moved_ != nullptr ? moved_->at_rest(place) : place);
  }

  // Numbers of computed images, for tests of the cache: samples of the patient, and grey levels from samples.
  int sampled() const { return sampled_; }
  int painted() const { return painted_; }

 private:
  void sample(const imaging::SlicePlane& plane, const SliceLook& look);
  void sample_moved(const imaging::SlicePlane& plane, const SliceLook& look);
  void paint(const SliceLook& look);

  std::shared_ptr<const OpenCase> patient_;
  std::optional<ForbiddenPlaces> places_;
  std::array<Tint, 256> tints_{};
  imaging::SlicePlane plane_;
  scene::BreathMotion breath_;
  std::shared_ptr<const imaging::TissueDisplacement> moved_;
  std::optional<SliceLook> look_;        // of the image; empty: not painted yet
  std::vector<float> hounsfield_;        // height x width
  std::vector<Tint> tint_;               // height x width
  std::vector<std::uint8_t> forbidden_;  // height x width
  QImage picture_;
  int sampled_ = 0, painted_ = 0;
};

}  // namespace bodkin::views
