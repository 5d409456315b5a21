#pragma once

#include <array>
#include <vector>

#include "patient/synthetic/torso.h"

namespace bodkin::patient {

// The whole synthetic patient as a function of position. Immutable and thread-safe.
class LumbarModel {
 public:
  LumbarModel(const LumbarSizes& sizes, std::uint64_t seed);

  // Everything that depends only on height: sections at z - spacing, z and z + spacing.
  struct Slice {
    std::array<SpineSection, 3> spine;
    TorsoSection torso;
    unsigned bones = 0;
    double spacing = 1.0;
    const SpineSection& here() const { return spine[1]; }
  };
  Slice slice(double z, double spacing) const;

  // The material of the voxel at p, whose height is the slice's. The dura is at least one voxel thick everywhere,
  // corners included: real dura is 0.4 mm.
  Material at(const Vec3& p, const Slice& slice) const;

  const Spine& spine() const { return spine_; }
  const Torso& torso() const { return torso_; }
  // Signed distance to the skin at any point.
  double skin_distance(const Vec3& p) const;
  // Distance to the nearest bone at any point.
  double bone_clearance(const Vec3& p) const;

 private:
  Material bone(const Vec3& p, const BoneHit& hit, const Slice& slice) const;
  Material sac(const Vec3& p, const Slice& slice, double distance) const;
  Material ligament(const Vec3& p, const Slice& slice, double canal) const;

  bool is_calcified(const Vec3& p, double front, double back) const;

  Spine spine_;
  Torso torso_;
  double calcification_;
  std::uint64_t seed_;
};

// The meaning of the labels, for the structures in `labels`.
std::vector<anatomy::Structure> lumbar_structures(const anatomy::LabelVolume& labels);

}  // namespace bodkin::patient
