#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "station/slice_field.h"
#include "station/tissue_lattice.h"
#include "station/ultrasound_choice.h"

#include "anatomy/case.h"
#include "fem/moving/deformable_body_solver.h"
#include "imaging/image_rgb.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::station {

// What a probe in somebody's hand sees of a patient whom it presses, picture after picture, without a session and
// without a thread. A patient with a mesh is deformed by the probe's face as by a second hand's (fem::BodyThread), a
// sixtieth of a second a step; without one the ultrasound gives way layer by layer, and the CT does not.
class PressedScan {
 public:
  // `patient` must outlive it. `folder`: of the case; empty: without a mesh. `note` hears what was assumed. Throws
  // InputError for a damaged mesh.
  PressedScan(const anatomy::Case& patient, const std::filesystem::path& folder, const UltrasoundChoice& choice,
              const std::function<void(const std::string&)>& note);

  // The patient has a mesh, and its solver has not failed.
  bool deforms() const { return solver_ != nullptr && !failed_; }
  // So much time goes by for the body, 0.5 s at most, while the probe goes to `probe` (its own frame, LPS); nothing:
  // it is lifted. It comes to the skin along its own axis and goes no faster than 300 mm/s.
  void advance(const std::optional<Pose>& probe, double seconds);
  // The ultrasound of the place to which it was advanced last.
  const imaging::UltrasoundFrame& image(const Pose& probe, const std::optional<imaging::NeedleInSound>& needle);
  // The CT in the plane of the last image, deformed like it; `pixel`: mm.
  imaging::ImageRgb slice(const Pose& probe, double pixel = 0.5);
  // How the tissue has moved since it rested, anywhere, for pictures in other planes; null: it has not.
  std::shared_ptr<const imaging::MovedTissue> moved_tissue() const;
  // Throws InputError for a knob that cannot be so.
  void set(const imaging::UltrasoundSettings& settings) { machine_.set(settings); }
  const imaging::UltrasoundSettings& settings() const { return machine_.settings(); }

  // mm, the farthest that the probe has moved anything in the plane of the last image.
  double most_moved() const { return most_; }
  // N on the probe along its axis, out of the skin; 0 where the body does not move.
  double force() const { return force_; }

 private:
  void take_displacements();
  imaging::SlicePlane plane_of_image(const Pose& probe) const;

  const anatomy::Case& patient_;
  imaging::Ultrasound machine_;
  std::shared_ptr<const fem::BodyDescription> body_;  // null: there is no mesh
  std::unique_ptr<fem::DeformableBodySolver> solver_;
  std::unique_ptr<SliceField> field_;
  std::unique_ptr<TissueLattice> lattice_;
  std::vector<float> nodes_;   // mm, of every node of the mesh
  std::vector<float> places_;  // mm, of the image's grid, as ScanDisplacement has it
  imaging::UltrasoundFrame frame_;
  std::optional<Pose> at_;  // where the face is now
  double owed_ = 0.0;       // s that have not made a whole step
  double most_ = 0.0, force_ = 0.0;
  double sized_for_ = 0.0;  // mm, the depth of the machine for which frame_ has the size of a picture
  bool failed_ = false;
};

// The face of a probe for a mesh, as wide as its crystals; as thick as its housing, and no thinner than two edges of
// the mesh, for only nodes are met.
fem::ProbeFace face_of(const anatomy::UltrasoundProbe& probe, const anatomy::TetrahedralMesh& mesh);

// The pose of a tool (third axis out of its face) whose machine's probe is at `probe`: the inverse of
// probe_in_hand().
Pose tool_of_probe(const Pose& probe);

}  // namespace bodkin::station
