#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::patient {

using SegmentMask = anatomy::Volume<std::uint8_t>;  // 0 or 1

// What a stroke marks: all voxels whose centre is within `radius` of it, in every direction (a ball), or in its own
// slices alone (a disc).
struct Brush {
  double radius = 4.0;  // mm, more than 0
  bool is_ball = true;
  int normal = 2;  // of a disc: the axis of the lattice across which its slices lie, 0 to 2
};

// How labels are written over others.
enum class Overwriting : std::uint8_t {
  all,      // whatever is there
  nothing,  // only where there is no structure yet
};

// A segmentation that is corrected by hand, with everything that was done to it. What one press of the mouse or one
// filter has done is a step; steps can be undone and done again as long as they fit into the memory that is given to
// them. One thread.
class LabelEditor {
 public:
  // `memory`: bytes that the steps may take; beyond it the oldest can no longer be undone.
  explicit LabelEditor(anatomy::LabelVolume labels, std::size_t memory = std::size_t{256} << 20U);

  const anatomy::LabelVolume& labels() const noexcept { return labels_; }

  // Writes `label` along the segment between two points (LPS mm); belongs to the step that commit() closes.
  void paint(const Vec3& from, const Vec3& to, const Brush& brush, std::uint16_t label, Overwriting over);
  // The same, but takes `label` away.
  void erase(const Vec3& from, const Vec3& to, const Brush& brush, std::uint16_t label);
  // The structure `label` becomes `mask`, which lies on the same lattice; a step of its own. Without `only_add` what
  // it had outside the mask goes. Throws std::invalid_argument for a mask of another size.
  void replace(const SegmentMask& mask, std::uint16_t label, Overwriting over, bool only_add);
  // All labels become these, which lie on the same lattice; a step of its own. Throws std::invalid_argument for
  // others.
  void take(const anatomy::LabelVolume& labels);
  // What was painted since the last step becomes a step; nothing when it changed nothing.
  void commit();

  bool can_undo() const noexcept { return now_ > 0; }
  bool can_redo() const noexcept { return now_ < steps_.size(); }
  void undo();
  void redo();

  // Rises with every voxel that changed, also by undo().
  std::uint64_t version() const noexcept { return version_; }
  // Where the voxels of `label` are 1.
  SegmentMask mask_of(std::uint16_t label) const;
  // Voxels of it.
  std::size_t count(std::uint16_t label) const;

 private:
  struct Change {
    std::uint64_t offset;
    std::uint16_t before, after;
  };
  using Step = std::vector<Change>;

  template <typename Wanted>
  void stroke(const Vec3& from, const Vec3& to, const Brush& brush, const Wanted& wanted);
  void set(std::size_t offset, std::uint16_t label);

  anatomy::LabelVolume labels_;
  std::size_t memory_, used_ = 0;
  Step open_;
  std::vector<Step> steps_;
  std::size_t now_ = 0;  // steps that are done
  std::uint64_t version_ = 0;
};

}  // namespace bodkin::patient
