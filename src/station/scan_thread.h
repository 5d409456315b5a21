#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "station/left_needle_motion.h"
#include "station/node_field.h"
#include "station/pressed_layers.h"
#include "station/slice_field.h"

#include "core/latest_value.h"
#include "fem/node_forces.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin::station {

// Where the probe is and how the machine is set.
struct ScanOrder {
  Pose probe = Pose::Identity();  // probe to patient, LPS
  imaging::UltrasoundSettings settings;
};

// One picture of a patient who moves.
struct LivePicture {
  std::uint64_t number = 0;  // counts the pictures that were made; 0: none yet
  imaging::UltrasoundFrame frame;
  ScanOrder order;                 // that it follows
  std::optional<Pose> needle;      // in it; none before the first tick
  std::vector<Pose> left;          // needles that were left, in it
  imaging::ScanDisplacement grid;  // of `moved`, whose `moved` is not set; no columns where the tissue is at rest
  std::vector<float> moved;        // mm, as ScanDisplacement has it
  double most = 0.0;               // mm, the farthest that the body has moved anything in the picture, layers apart
  double left_out = 0.0;           // N of the needle's forces that the picture does not show
  double milliseconds = 0.0;       // that it took
  bool refused = false;            // the settings of the order cannot be: those of the last picture stayed
};

// How the patient of a live ultrasound deforms: a deformable body, static or moving, and breath.
struct ScanBody {
  std::shared_ptr<const fem::BodyDescription>
      mesh;                              // null: no body; only the probe compresses tissue, layer by layer
  std::unique_ptr<NodeField> by_forces;  // its displacements by the needle's forces; may be null
  // A body that moves by itself, feels the probe too and gives that motion by set_displacements(). To a static one
  // the probe's compression is added layer by layer.
  bool moves = false;
  std::optional<anatomy::BreathField> breath = {};  // nothing: nobody breathes
  LeftNeedleMotion left = {};                       // needles that were left in it, with the same breath
};

// Simulates ultrasound pictures repeatedly on a thread of its own, from the newest needle and forces of the tick and
// the newest order. No thread ever waits for another: all exchange values through LatestValue.
class ScanThread {
 public:
  // `machine`: for `patient`. `rate`: pictures per second at most, 1 to 1000. Throws InputError for another rate.
  ScanThread(std::shared_ptr<const imaging::AcousticVolume> patient, imaging::Ultrasound machine,
             const anatomy::Needle& needle, ScanBody body, const ScanOrder& first, double rate = 60.0);

  // The tick's thread only; wait-free. Forces by node of the mesh; the needle as it is in the body; how far breath is
  // drawn in.
  void set_needle(const fem::NodeForces& forces, const Pose& needle, double drawn_in = 0.0) noexcept {
    ticks_.write({forces, needle, true, drawn_in});
  }

  // Observer's thread, and so the two below: what the next pictures follow.
  void set_order(const ScanOrder& order) noexcept { orders_.write(order); }
  // mm, 3 per node of the mesh, of a moving body, and the nodes that a probe holds; another number of values is
  // ignored.
  void set_displacements(std::span<const float> nodes, std::span<const std::uint32_t> held = {});
  // The newest picture, unchanged until the next call.
  const LivePicture& picture() noexcept { return pictures_.read(); }

 private:
  struct Tick {
    fem::NodeForces forces;
    Pose needle = Pose::Identity();
    bool published = false;
    double drawn_in = 0.0;
  };
  void run(const std::stop_token& stop, double rate);
  void make(LivePicture& now);
  void add_breath(LivePicture& now, const imaging::SlicePlane& grid, double drawn_in) const;
  void add_layers(LivePicture& now, const imaging::SlicePlane& grid);
  void move_tissue(LivePicture& now, const Tick& tick);
  void move_body(LivePicture& now, const imaging::SlicePlane& grid, const fem::NodeForces& forces);
  void move_left_needles(LivePicture& now, double drawn_in);
  Vec3 by_layers(const Vec3& place) const;

  imaging::Ultrasound machine_;
  anatomy::Needle needle_;
  ScanBody body_;
  std::unique_ptr<SliceField> slice_;
  std::optional<PressedLayers> layers_;
  std::vector<float> moved_;                       // mm, of every node of the mesh, in this picture
  std::vector<fem::PointInMesh> left_places_;      // of the points of needles that were left; empty without a mesh
  std::vector<float> left_moved_;                  // mm, of these points, in this picture
  std::vector<imaging::NeedleInSound> left_seen_;  // as the machine has them
  Vec3 carried_ = Vec3::Zero();    // mm, by which breath has moved the tissue at the probe, in this picture
  Pose probe_ = Pose::Identity();  // of this picture, where it would be had the tissue at it not moved
  LatestValue<Tick> ticks_;
  LatestValue<ScanOrder> orders_;
  LatestValue<std::vector<float>> nodes_;
  LatestValue<std::vector<std::uint32_t>> held_;
  LatestValue<LivePicture> pictures_;
  std::optional<imaging::UltrasoundSettings> wanted_;  // of the last picture, and its depth, mm: of the thread
  double depth_ = 0.0;
  std::vector<float> told_;  // of the observer's thread, and so is the next
  std::vector<std::uint32_t> told_held_;
  std::jthread thread_;  // the last member: it uses the others
};

}  // namespace bodkin::station
