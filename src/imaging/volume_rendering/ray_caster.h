#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/thread_pool.h"
#include "imaging/rest_offsets.h"
#include "imaging/volume_rendering/prepared_volume.h"
#include "imaging/volume_rendering/transfer_function.h"

namespace bodkin::imaging {

enum class VolumeMode : std::uint8_t {
  colour,   // light through coloured, shaded tissue
  grey,     // as colour, in the grey levels of a window
  maximum,  // the largest HU on each ray (MIP)
  sum       // sum over each ray, weighted as in an X-ray
};

// The display settings of a volume view.
struct VolumeLook {
  VolumeMode mode = VolumeMode::colour;
  TransferFunction transfer = preset_function(TransferPreset::bone);  // of colour and grey
  double window = 1200.0, level = 300.0;                              // HU; of grey and maximum
  double brightness = 0.75;                  // for sum: 1 is white at the patient's thickest part; 0.1 to 10
  bool shaded = true;                        // light from the viewer's side on edges of HU
  bool tissue_colours = false;               // colours of the tissues instead of those of the HU
  std::array<std::uint32_t, 256> tissues{};  // 0xRRGGBB, by TissueId
  std::uint32_t background = 0x0E1116;       // 0xRRGGBB, for colour and grey; the other modes have a black background

  bool operator==(const VolumeLook&) const = default;
};

// Rays of a pinhole camera: that of pixel (x, y) runs from `eye` along `first` + x `right` + y `down`, LPS mm.
struct VolumeCamera {
  Vec3 eye = Vec3::Zero();
  Vec3 first = Vec3::UnitY();  // through the middle of the upper left pixel
  Vec3 right = Vec3::Zero(), down = Vec3::Zero();
  int width = 0, height = 0;  // pixels
};

// Result of one ray.
struct CastRay {
  float red = 0.0F, green = 0.0F, blue = 0.0F;  // 0 to 1, for colour and grey: weighted by the opacity before
  float opacity = 0.0F;                         // 0 to 1
  float most = -32768.0F;                       // HU, of maximum
  float sum = 0.0F;                             // mm of water, of sum
};

// Casts rays through a patient on the processor. Blocks in which nothing is visible are skipped; neither this nor the
// number of threads changes a bit of the image.
class RayCaster {
 public:
  // `step`: mm between samples, above 0; a voxel or less is full quality. Colour and grey use longer steps when less
  // than a quarter of a ray's light is left.
  RayCaster(std::shared_ptr<const PreparedVolume> volume, const VolumeLook& look, double step);

  // Pixels 0xffRRGGBB, row by row. `cancelled` is called often, from several threads; once it is true, the remaining
  // pixels are not computed and the return value is false.
  bool draw(const VolumeCamera& camera, ThreadPool& pool, std::vector<std::uint32_t>& pixels,
            const std::function<bool()>& cancelled = {}) const;
  // One ray from the eye (or from its entry into the patient) to `until` mm from the eye. `direction`: unit.
  // `far_apart`: its neighbours are more than about a voxel away, so that its data are not in the cache; it then
  // prefetches. The result is the same.
  CastRay cast(const Vec3& eye, const Vec3& direction, double until, bool far_apart = false) const;
  // The colour of a ray's result, 0xffRRGGBB.
  std::uint32_t colour(const CastRay& ray) const;

  // From now on tissue is drawn at its moved positions. It is lit as at rest. Null: it rests.
  void set_moved(const RestOffsets* moved);

  const VolumeLook& look() const { return look_; }
  const PreparedVolume& volume() const { return *volume_; }
  double step() const { return step_; }
  // For tests: samples every block.
  void skip_nothing();

 private:
  void find_skips();

  std::shared_ptr<const PreparedVolume> volume_;
  VolumeLook look_;
  double step_;
  Mat3 index_from_mm_;    // LPS mm to the index with the border: this times the point
  Vec3 index_of_origin_;  // plus this
  // By HU from -1024 to 3071.
  std::vector<float> depth_;                 // optical, of 1 mm
  std::array<std::vector<float>, 3> shown_;  // the opacity of one step, of one twice and of one four times as long
  std::vector<float> colours_;               // red, green, blue, 0
  std::vector<float> tissue_colours_;        // red, green, blue, 0 by TissueId; empty: not used
  // Of every block: the distance in blocks, in the largest of the three directions, to one with something visible; 0:
  // itself.
  std::vector<std::uint8_t> away_;
  PointLattice moved_lattice_;
  std::vector<float> moved_;  // index, see kernel::Field; empty: nothing has moved
  int moved_blocks_ = 0;
};

// A step of the given number of the volume's finest voxels, mm.
double step_of(const PreparedVolume& volume, double voxels);

}  // namespace bodkin::imaging
