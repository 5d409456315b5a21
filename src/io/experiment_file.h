#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/case.h"

namespace bodkin::io {

class XmlSchema;

// A needle experiment as described by its file: the body, the needle, its motion, the plots, and the published
// numbers (docs/figures.md describes the format). The needle enters at the origin of depth; depth runs inwards.

// A stack of plane layers with the skin at z = 0 and depth along +z, or a half ball, its pole at the origin, with
// layers as shells from outside to inside and its middle made of the last layer. Or a patient: a case folder, whose
// motion runs along a path with depth counted from the skin.
struct ExperimentLayer {
  std::string tissue;
  double thickness = 0.0;  // mm
};
struct ExperimentBody {
  bool hemisphere = false;
  double radius = 0.0;  // mm, of the half ball
  double width = 60.0;  // mm, of the stack across the needle
  double voxel = 0.5;   // mm
  double mesh = 5.0;    // mm, longest edge along each axis of a stack's mesh, for resistances that need one
  std::vector<ExperimentLayer> layers;
  std::filesystem::path patient;      // the case's folder; empty for a stack or a half ball
  std::optional<Vec3> entry, target;  // LPS mm, of a patient; the planned path if absent
};

// The position of the needle at a time; it moves uniformly between two of them. All are relative to `entry` along
// `direction`.
struct ExperimentPlace {
  double time = 0.0;   // s
  double depth = 0.0;  // mm of the tip along the direction, negative outside
  double aside = 0.0;  // mm of the tip across it
  double tilt = 0.0;   // rad of the needle in the plane of direction and aside
};
struct ExperimentMotion {
  Vec3 entry = Vec3::Zero();            // mm
  Vec3 direction = Vec3::UnitZ();       // unit
  Vec3 across = Vec3::UnitX();          // unit; direction of `aside`
  bool tilt_about_tip = false;          // otherwise about the entry
  std::vector<ExperimentPlace> places;  // times rise from 0

  // Sets `entry`, `direction` (of any length) and the lateral axis.
  void lay_along(const Vec3& from, const Vec3& towards);
};

// The quantities that can be drawn and compared, one number per tick. Forces and torques are those requested by the
// models, before the governor, on the hand; `applied` is the force after the governor.
enum class Quantity : std::uint8_t {
  time,
  depth,
  position,  // along the motion's direction, in air too
  velocity,
  resistance,
  force,
  force_x,
  force_y,
  force_z,
  applied_force,
  constraint,
  torque,
  applied_torque,
  tip_x,
  tip_y,
  tip_z,
  aside,
  tilt,
  wall,  // of `tracking_wall`, while its spring is under load
  wall_x,
  wall_y,
  wall_z,
  proxy_x,  // of `volume_proxy`
  proxy_y,
  proxy_z
};
struct QuantityName {
  std::string_view name;   // in experiment files, with its unit
  std::string_view label;  // for people
};
inline constexpr std::array<QuantityName, 25> quantity_names = {{{"time_s", "time, s"},
                                                                 {"depth_mm", "depth, mm"},
                                                                 {"position_mm", "position, mm"},
                                                                 {"velocity_mm_per_s", "velocity, mm/s"},
                                                                 {"resistance_N", "resistance, N"},
                                                                 {"force_N", "force, N"},
                                                                 {"force_x_N", "force along x, N"},
                                                                 {"force_y_N", "force along y, N"},
                                                                 {"force_z_N", "force along z, N"},
                                                                 {"applied_force_N", "force on the hand, N"},
                                                                 {"constraint_N", "force across the needle, N"},
                                                                 {"torque_N_mm", "torque, N mm"},
                                                                 {"applied_torque_N_mm", "torque on the hand, N mm"},
                                                                 {"tip_x_mm", "x, mm"},
                                                                 {"tip_y_mm", "y, mm"},
                                                                 {"tip_z_mm", "z, mm"},
                                                                 {"aside_mm", "aside, mm"},
                                                                 {"tilt_deg", "tilt, deg"},
                                                                 {"wall_mm", "wall, mm"},
                                                                 {"wall_x_mm", "wall x, mm"},
                                                                 {"wall_y_mm", "wall y, mm"},
                                                                 {"wall_z_mm", "wall z, mm"},
                                                                 {"proxy_x_mm", "proxy x, mm"},
                                                                 {"proxy_y_mm", "proxy y, mm"},
                                                                 {"proxy_z_mm", "proxy z, mm"}}};

// A part of an experiment: ticks that satisfy both conditions.
struct ExperimentWindow {
  std::optional<double> time_from, time_to;    // s
  std::optional<double> depth_from, depth_to;  // mm
};

struct ExperimentCurve {
  Quantity quantity = Quantity::resistance;
  std::optional<Quantity> x;  // instead of the panel's
  std::string name;
  bool right = false;  // on the axis on the right
};
struct ExperimentPanel {
  std::string title;
  Quantity x = Quantity::time;
  std::string x_label, y_label, right_label;  // empty: that of the first curve there
  ExperimentWindow window;                    // the part of the experiment to be drawn
  double height = 260.0;                      // px
  bool down = false;                          // the y axis points down, as depth does
  bool tissues = false;                       // bands of the tissues at the tip
  std::vector<ExperimentCurve> curves;
};

enum class Aggregation : std::uint8_t { mean, highest, lowest, first, last };
// A published number and the part of the experiment to which it applies.
struct PublishedValue {
  std::string what;    // "force in the layer"
  std::string source;  // "section 3.1"
  Quantity quantity = Quantity::resistance;
  Aggregation aggregation = Aggregation::mean;
  ExperimentWindow window;
  double value = 0.0;      // in the quantity's unit
  double tolerance = 0.0;  // for agreement
};

// Information on the figure for readers, each one paragraph.
struct ExperimentCaption {
  std::string reproduces, parameters, agrees, differs;
};

struct Experiment {
  std::string name;  // used for file names
  std::string title;
  std::string paper;  // the publication, empty for an experiment of one's own
  ExperimentCaption caption;
  anatomy::TissueLibrary library;  // the library that comes with Bodkin, with the experiment's changes
  ExperimentBody body;
  anatomy::Needle needle;
  anatomy::DeviceLimits device;
  anatomy::HapticSettings haptics;
  ExperimentMotion motion;
  std::vector<ExperimentPanel> panels;
  std::vector<PublishedValue> values;
  std::optional<anatomy::Case> patient;  // of a body that is a patient, after loading (study/experiment.h)
};

// Reads an experiment from text in memory; `origin` names it in messages, and folders of patients are relative to its
// folder. For a patient only the description and the tissue library are read, not the volumes; needle, device and
// haptics missing in the file are the patient's. Throws InputError naming file, line, what was found and what was
// expected.
Experiment parse_experiment(std::string_view document, const std::string& origin);
Experiment read_experiment(const std::filesystem::path& file);

// The experiments that come with Bodkin (share/bodkin/experiments), by name.
std::vector<std::filesystem::path> shipped_experiments();

}  // namespace bodkin::io
