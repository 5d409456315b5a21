#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "station/compressed_layers.h"
#include "station/left_needle_motion.h"
#include "station/node_field.h"
#include "station/slice_field.h"

#include "core/latest_value.h"
#include "fem/node_forces.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::station {

// The pose of the probe and the settings of the machine.
struct ScanSetup {
  Pose probe = Pose::Identity();  // probe to patient, LPS
  imaging::UltrasoundSettings settings;
};

// One image of a moving patient.
struct LiveImage {
  std::uint64_t number = 0;  // number of the image; 0: none yet
  imaging::UltrasoundFrame frame;
  ScanSetup setup;                 // that it shows
  std::optional<Pose> needle;      // in the image; none before the first tick
  std::vector<Pose> left;          // needles left in the body, in the image
  imaging::ScanDisplacement grid;  // points of `moved`, not set in itself; no columns if the tissue is at rest
  std::vector<float> moved;        // mm, in the format of ScanDisplacement
  double most = 0.0;               // mm, largest displacement by the body in the image, without compressed layers
  double left_out = 0.0;           // N of the needle's forces that the image omits
  double milliseconds = 0.0;       // to compute it
  bool refused = false;            // the settings are invalid: those of the last image stayed
};

// The deformation of the patient of a live ultrasound: a deformable body, static or moving, and breathing.
struct ScanBody {
  std::shared_ptr<const fem::BodyDescription>
      mesh;                              // null: no body; only the probe compresses tissue, layer by layer
  std::unique_ptr<NodeField> by_forces;  // its displacements by the needle's forces; may be null
  // The body moves on its own, feels the probe too, and gives its motion by set_displacements(). For a static body
  // the probe's compression is added layer by layer.
  bool moves = false;
  std::optional<anatomy::BreathField> breath = {};  // empty: no breathing
  LeftNeedleMotion left = {};                       // of needles left in the body, with the same breathing
};

// Simulates ultrasound images repeatedly on its own thread, from the newest needle and forces of the tick and the
// newest setup. No thread ever waits for another: all exchange values through LatestValue.
class ScanThread {
 public:
  // `machine`: for `patient`. `rate`: images per second at most, 1 to 1000. Throws InputError for another rate.
  ScanThread(std::shared_ptr<const imaging::AcousticVolume> patient, imaging::Ultrasound machine,
             const anatomy::Needle& needle, ScanBody body, const ScanSetup& first, double rate = 60.0);

  // The tick's thread only; wait-free. Forces by node of the mesh; the pose of the needle in the body; depth of
  // inspiration.
  void set_needle(const fem::NodeForces& forces, const Pose& needle, double drawn_in = 0.0) noexcept {
    ticks_.write({forces, needle, true, drawn_in});
  }

  // Observer's thread, as the next two functions: the setup for the next images.
  void set_setup(const ScanSetup& setup) noexcept { setups_.write(setup); }
  // mm, 3 per node of the mesh, of a moving body, and the nodes that a probe holds; any other number of values is
  // ignored.
  void set_displacements(std::span<const float> nodes, std::span<const std::uint32_t> held = {});
  // The newest image, unchanged until the next call.
  const LiveImage& picture() noexcept { return pictures_.read(); }

 private:
  struct Tick {
    fem::NodeForces forces;
    Pose needle = Pose::Identity();
    bool published = false;
    double drawn_in = 0.0;
  };
  void run(const std::stop_token& stop, double rate);
  void make(LiveImage& now);
  void add_breath(LiveImage& now, const imaging::SlicePlane& grid, double drawn_in) const;
  void add_layers(LiveImage& now, const imaging::SlicePlane& grid);
  void move_tissue(LiveImage& now, const Tick& tick);
  void move_body(LiveImage& now, const imaging::SlicePlane& grid, const fem::NodeForces& forces);
  void move_left_needles(LiveImage& now, double drawn_in);
  Vec3 by_layers(const Vec3& place) const;

  imaging::Ultrasound machine_;
  anatomy::Needle needle_;
  ScanBody body_;
  std::unique_ptr<SliceField> slice_;
  std::optional<CompressedLayers> layers_;
  std::vector<float> moved_;                            // mm, of every node of the mesh, in this image
  std::vector<fem::PointInMesh> left_places_;           // of the points of left needles; empty without a mesh
  std::vector<float> left_moved_;                       // mm, of these points, in this image
  std::vector<imaging::NeedleInUltrasound> left_seen_;  // in the machine's format
  Vec3 carried_ = Vec3::Zero();    // mm, motion of the tissue at the probe by breathing, in this image
  Pose probe_ = Pose::Identity();  // of this image, relative to the tissue at rest
  LatestValue<Tick> ticks_;
  LatestValue<ScanSetup> setups_;
  LatestValue<std::vector<float>> nodes_;
  LatestValue<std::vector<std::uint32_t>> held_;
  LatestValue<LiveImage> pictures_;
  std::optional<imaging::UltrasoundSettings> wanted_;  // of the last image, and its depth, mm: used by the thread
  double depth_ = 0.0;
  std::vector<float> reported_;  // used by the observer's thread, as is the next
  std::vector<std::uint32_t> reported_held_;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace bodkin::station
