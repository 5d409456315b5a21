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

// The images of a hand-held probe that presses a patient, one after another, without a session and without a thread.
// A patient with a mesh is deformed by the probe's face as by that of a second hand (fem::BodyThread), a sixtieth of
// a second per step; without one the ultrasound image is compressed layer by layer, and the CT is not.
class PressedScan {
 public:
  // `patient` must outlive this object. `folder`: of the case; empty: without a mesh. `note` receives the assumptions
  // made. Throws InputError for a damaged mesh.
  PressedScan(const anatomy::Case& patient, const std::filesystem::path& folder, const UltrasoundChoice& choice,
              const std::function<void(const std::string&)>& note);

  // Whether the patient has a mesh, and its solver has not failed.
  bool deforms() const { return solver_ != nullptr && !failed_; }
  // Advances the body by this time, at most 0.5 s, while the probe moves to `probe` (its own frame, LPS); empty: it
  // is lifted. It approaches the skin along its own axis and no faster than 300 mm/s.
  void advance(const std::optional<Pose>& probe, double seconds);
  // The ultrasound image at the last place of advance().
  const imaging::UltrasoundFrame& image(const Pose& probe, const std::optional<imaging::NeedleInUltrasound>& needle);
  // The CT in the plane of the last image, deformed like it; `pixel`: mm.
  imaging::ImageRgb slice(const Pose& probe, double pixel = 0.5);
  // The displacement of the tissue from rest, anywhere, for images in other planes; null: none.
  std::shared_ptr<const imaging::TissueDisplacement> moved_tissue() const;
  // Throws InputError for invalid settings.
  void set(const imaging::UltrasoundSettings& settings) { machine_.set(settings); }
  const imaging::UltrasoundSettings& settings() const { return machine_.settings(); }

  // mm, the largest displacement in the plane of the last image.
  double most_moved() const { return most_; }
  // N on the probe along its axis, out of the skin; 0 without a moving body.
  double force() const { return force_; }

 private:
  void take_displacements();
  imaging::SlicePlane plane_of_image(const Pose& probe) const;

  const anatomy::Case& patient_;
  imaging::Ultrasound machine_;
  std::shared_ptr<const fem::BodyDescription> body_;  // null: no mesh
  std::unique_ptr<fem::DeformableBodySolver> solver_;
  std::unique_ptr<SliceField> field_;
  std::unique_ptr<TissueLattice> lattice_;
  std::vector<float> nodes_;   // mm, of every node of the mesh
  std::vector<float> places_;  // mm, of the image's grid, as ScanDisplacement has it
  imaging::UltrasoundFrame frame_;
  std::optional<Pose> at_;  // present pose of the face
  double owed_ = 0.0;       // s that do not make a whole step yet
  double most_ = 0.0, force_ = 0.0;
  double sized_for_ = 0.0;  // mm, depth of the machine for which frame_ has the right size
  bool failed_ = false;
};

// The face of a probe for a mesh, as wide as its crystals; as thick as its housing, and at least two edges of the
// mesh, because only nodes are met.
fem::ProbeFace face_of(const anatomy::UltrasoundProbe& probe, const anatomy::TetrahedralMesh& mesh);

// The pose of a tool (third axis out of its face) whose machine's probe is at `probe`: the inverse of
// probe_in_hand().
Pose tool_of_probe(const Pose& probe);

}  // namespace bodkin::station
