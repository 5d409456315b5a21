#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "station/node_field.h"
#include "station/pressed_layers.h"
#include "station/slice_field.h"

#include "core/latest_value.h"
#include "fem/node_forces.h"
#include "imaging/ultrasound/ultrasound.h"

namespace bodkin {

// What a person has an ultrasound machine do.
struct ScanOrder {
  Pose probe = Pose::Identity();  // probe to patient, LPS
  UltrasoundSettings settings;
};

// One picture of a patient who moves.
struct LivePicture {
  std::uint64_t number = 0;  // counts the pictures that were made; 0: none yet
  UltrasoundFrame frame;
  ScanOrder order;             // that it follows
  std::optional<Pose> needle;  // in it; none before the first tick
  ScanDisplacement grid;       // of `moved`, whose `moved` is not set; no columns where the tissue is at rest
  std::vector<float> moved;    // mm, as ScanDisplacement has it
  double most = 0.0;           // mm, the farthest that the body has moved anything in the picture, layers apart
  double left_out = 0.0;       // N of the needle's forces that the picture does not show
  double milliseconds = 0.0;   // that it took
  bool refused = false;        // the settings of the order cannot be: those of the last picture stayed
};

// The deformable body as a picture needs it: either of both, or neither.
struct ScanBody {
  std::shared_ptr<const BodyDescription> mesh;  // null: nothing moves but what a probe presses, layer by layer
  // Null: how nodes have moved is told (tell_nodes), by a body that feels the probe, too. Otherwise what the probe
  // presses is added layer by layer.
  std::unique_ptr<NodeField> by_forces;
};

// Makes an ultrasound picture again and again on a thread of its own, from the newest needle and forces that the tick
// has told it, and the newest place of the probe. Nobody waits for anybody: all exchange values through LatestValue.
class ScanThread {
 public:
  // `machine` is of `patient`. `rate`: pictures a second, 1 to 1000, where they can be made as fast. Throws
  // InputError when it is not.
  ScanThread(std::shared_ptr<const AcousticVolume> patient, Ultrasound machine, const Needle& needle, ScanBody body,
             const ScanOrder& first, double rate = 60.0);

  // The tick's thread only; wait-free. Forces by node of the mesh; the needle as it is in the body.
  void tell(const NodeForces& forces, const Pose& needle) noexcept { ticks_.write({forces, needle, true}); }

  // One watching thread: what the next pictures follow.
  void order(const ScanOrder& order) noexcept { orders_.write(order); }
  // mm, 3 a node of the mesh, of a body that moves by itself; fewer are left out.
  void tell_nodes(std::span<const float> nodes);
  // The newest picture, which stays as it is until the next call.
  const LivePicture& picture() noexcept { return pictures_.read(); }

 private:
  struct Tick {
    NodeForces forces;
    Pose needle = Pose::Identity();
    bool told = false;
  };
  void run(const std::stop_token& stop, double rate);
  void make(LivePicture& now);
  void add_layers(LivePicture& now, const SlicePlane& grid);
  void move_tissue(LivePicture& now, const NodeForces& forces);

  Ultrasound machine_;
  Needle needle_;
  ScanBody body_;
  std::unique_ptr<SliceField> slice_;
  std::optional<PressedLayers> layers_;
  LatestValue<Tick> ticks_;
  LatestValue<ScanOrder> orders_;
  LatestValue<std::vector<float>> nodes_;
  LatestValue<LivePicture> pictures_;
  std::optional<UltrasoundSettings> wanted_;  // of the last picture, and its depth, mm: of the thread
  double depth_ = 0.0;
  std::vector<float> told_;  // of the watching thread
  std::jthread thread_;      // the last member: it uses the others
};

}  // namespace bodkin
