#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "anatomy/volume.h"

namespace bodkin::patient {

using SegmentMask = anatomy::Volume<std::uint8_t>;  // 0 or 1

// The voxels marked by a stroke: all whose centre is within `radius` of it, in every direction (a ball), or only in
// its own slices (a disc).
struct Brush {
  double radius = 4.0;  // mm, more than 0
  bool is_ball = true;
  int normal = 2;  // of a disc: the axis of the lattice across which its slices lie, 0 to 2
};

// Which existing labels are overwritten.
enum class Overwriting : std::uint8_t {
  all,      // any label
  nothing,  // only where there is no structure yet
};

// A segmentation that is corrected by hand, with its history. The effect of one press of the mouse or one filter is a
// step; steps can be undone and redone as long as they fit into the given memory. One thread.
class LabelEditor {
 public:
  // `memory`: bytes for the steps; beyond it the oldest can no longer be undone.
  explicit LabelEditor(anatomy::LabelVolume labels, std::size_t memory = std::size_t{256} << 20U);

  const anatomy::LabelVolume& labels() const noexcept { return labels_; }

  // Writes `label` along the segment between two points (LPS mm); part of the step that commit() closes.
  void paint(const Vec3& from, const Vec3& to, const Brush& brush, std::uint16_t label, Overwriting over);
  // As paint(), but removes `label`.
  void erase(const Vec3& from, const Vec3& to, const Brush& brush, std::uint16_t label);
  // The structure `label` becomes `mask`, which must lie on the same lattice; a step of its own. Without `only_add`
  // its voxels outside the mask are removed. Throws std::invalid_argument for a mask of another size.
  void replace(const SegmentMask& mask, std::uint16_t label, Overwriting over, bool only_add);
  // Replaces all labels by these, which must lie on the same lattice; a step of its own. Throws std::invalid_argument
  // otherwise.
  void take(const anatomy::LabelVolume& labels);
  // Closes a step with everything painted since the last one; no step if nothing changed.
  void commit();

  bool can_undo() const noexcept { return now_ > 0; }
  bool can_redo() const noexcept { return now_ < steps_.size(); }
  void undo();
  void redo();

  // Increases with every voxel that changed, also by undo().
  std::uint64_t version() const noexcept { return version_; }
  // 1 at the voxels of `label`.
  SegmentMask mask_of(std::uint16_t label) const;
  // Number of its voxels.
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
  std::size_t now_ = 0;  // completed steps
  std::uint64_t version_ = 0;
};

}  // namespace bodkin::patient
