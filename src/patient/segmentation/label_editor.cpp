#include "patient/segmentation/label_editor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bodkin::patient {

LabelEditor::LabelEditor(anatomy::LabelVolume labels, std::size_t memory)
    : labels_(std::move(labels)), memory_(memory) {}

void LabelEditor::set(std::size_t offset, std::uint16_t label) {
  std::uint16_t& voxel = labels_.voxels[offset];
  if (voxel == label) return;
  open_.push_back({offset, voxel, label});
  voxel = label;
  ++version_;
}

template <typename Wanted>
void LabelEditor::stroke(const Vec3& from, const Vec3& to, const Brush& brush, const Wanted& wanted) {
  const anatomy::Grid& grid = labels_.grid;
  const Vec3 a = grid.to_index(from), b = grid.to_index(to);
  std::array<int, 3> low{}, high{};
  for (int axis = 0; axis < 3; ++axis) {
    const bool across = !brush.is_ball && axis == brush.normal;
    const double reach = across ? 0.5 : brush.radius / grid.spacing[axis];
    const auto i = static_cast<std::size_t>(axis);
    low[i] = std::max(0, static_cast<int>(std::ceil(std::min(a[axis], b[axis]) - reach)));
    high[i] = std::min(grid.size[i] - 1, static_cast<int>(std::floor(std::max(a[axis], b[axis]) + reach)));
  }
  const Vec3 along = to - from;
  const double squared = along.squaredNorm();
  const Vec3 normal = grid.direction.col(brush.normal);
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) {
        const Vec3 centre = grid.to_patient(Vec3(i, j, k));
        const double share = squared > 0.0 ? std::clamp(along.dot(centre - from) / squared, 0.0, 1.0) : 0.0;
        Vec3 away = centre - from - share * along;
        if (!brush.is_ball) away -= normal * normal.dot(away);
        if (away.squaredNorm() > brush.radius * brush.radius) continue;
        const std::size_t offset = grid.offset(i, j, k);
        set(offset, wanted(labels_.voxels[offset]));
      }
    }
  }
}

void LabelEditor::paint(const Vec3& from, const Vec3& to, const Brush& brush, std::uint16_t label, Overwriting over) {
  stroke(from, to, brush,
         [=](std::uint16_t there) { return over == Overwriting::all || there == 0 ? label : there; });
}

void LabelEditor::erase(const Vec3& from, const Vec3& to, const Brush& brush, std::uint16_t label) {
  stroke(from, to, brush, [=](std::uint16_t there) { return there == label ? std::uint16_t{0} : there; });
}

void LabelEditor::replace(const SegmentMask& mask, std::uint16_t label, Overwriting over, bool only_add) {
  if (mask.grid.size != labels_.grid.size) throw std::invalid_argument("a mask of another size than the labels");
  commit();
  for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
    const std::uint16_t there = labels_.voxels[i];
    if (mask.voxels[i] != 0) {
      if (there == 0 || over == Overwriting::all) set(i, label);
    } else if (there == label && !only_add) {
      set(i, 0);
    }
  }
  commit();
}

void LabelEditor::take(const anatomy::LabelVolume& labels) {
  if (labels.voxels.size() != labels_.voxels.size()) throw std::invalid_argument("labels of another size");
  commit();
  for (std::size_t i = 0; i < labels.voxels.size(); ++i) set(i, labels.voxels[i]);
  commit();
}

void LabelEditor::commit() {
  if (open_.empty()) return;
  for (std::size_t i = now_; i < steps_.size(); ++i) used_ -= steps_[i].size() * sizeof(Change);
  steps_.resize(now_);
  used_ += open_.size() * sizeof(Change);
  steps_.push_back(std::move(open_));
  open_.clear();
  while (steps_.size() > 1 && used_ > memory_) {
    used_ -= steps_.front().size() * sizeof(Change);
    steps_.erase(steps_.begin());
  }
  now_ = steps_.size();
}

void LabelEditor::undo() {
  commit();
  if (now_ == 0) return;
  const Step& step = steps_[--now_];
  for (auto change = step.rbegin(); change != step.rend(); ++change) labels_.voxels[change->offset] = change->before;
  version_ += step.size();
}

void LabelEditor::redo() {
  commit();
  if (now_ == steps_.size()) return;
  const Step& step = steps_[now_++];
  for (const Change& change : step) labels_.voxels[change.offset] = change.after;
  version_ += step.size();
}

SegmentMask LabelEditor::mask_of(std::uint16_t label) const {
  SegmentMask mask(labels_.grid);
  std::transform(labels_.voxels.begin(), labels_.voxels.end(), mask.voxels.begin(),
                 [label](std::uint16_t voxel) { return static_cast<std::uint8_t>(voxel == label ? 1 : 0); });
  return mask;
}

std::size_t LabelEditor::count(std::uint16_t label) const {
  return static_cast<std::size_t>(std::count(labels_.voxels.begin(), labels_.voxels.end(), label));
}

}  // namespace bodkin::patient
