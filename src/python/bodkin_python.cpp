// The Python module `bodkin`: patients and the haptic tick, for experiments with models. docs/python.md describes the
// interface.
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "patient/prepared_body.h"
#include "session/tick_codec.h"
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "core/error.h"
#include "core/shortest_turn.h"
#include "io/case_folder.h"
#include "io/force_choice.h"
#include "simulation/haptic_tick.h"

namespace py = pybind11;

namespace bodkin::python {

namespace {

// A case and the folder that it came from.
struct Patient {
  anatomy::Case data;
  std::filesystem::path folder;
};

std::shared_ptr<Patient> load_case(const std::string& folder, const std::string& resistance,
                                   const std::string& constraint, const std::vector<std::string>& parts) {
  const py::gil_scoped_release others_may_run;
  auto patient = std::make_shared<Patient>(Patient{io::load_case(folder), folder});
  anatomy::HapticSettings& haptics = patient->data.description.haptics;
  if (!resistance.empty()) haptics.resistance = io::parse_resistance(resistance, "resistance");
  if (!constraint.empty()) haptics.constraint = io::parse_constraint(constraint, "constraint");
  if (!parts.empty()) haptics.parts = io::parse_parts(parts, "parts");
  return patient;
}

Pose pose_of(const Eigen::Matrix4d& matrix) {
  constexpr double tolerance = 1e-6;
  const Mat3 turn = matrix.topLeftCorner<3, 3>();
  if (!matrix.allFinite() || !(turn.transpose() * turn).isIdentity(tolerance) || turn.determinant() < 0.0)
    throw InputError(
        "the pose is not a rigid 4 x 4 matrix, expected a rotation and a translation in mm; see needle_pose()");
  Pose pose = Pose::Identity();
  pose.linear() = turn;
  pose.translation() = matrix.topRightCorner<3, 1>();
  return pose;
}

// The needle with its tip there, its third axis along `axis`.
Eigen::Matrix4d needle_pose(const Vec3& tip, const Vec3& axis) {
  if (!tip.allFinite() || !axis.allFinite() || !(axis.norm() > 0.0))
    throw InputError("the tip and the axis must be finite, and the axis not zero");
  Eigen::Matrix4d pose = Eigen::Matrix4d::Identity();
  pose.topLeftCorner<3, 3>() = shortest_turn(Vec3::UnitZ(), axis.normalized()).toRotationMatrix();
  pose.topRightCorner<3, 1>() = tip;
  return pose;
}

py::list events_of(const simulation::TickOutput& output, const anatomy::TissueLibrary& library) {
  py::list events;
  for (const forces::Event& event : output.events) {
    py::dict one;
    one["event"] = std::string(session::event_kind_name(event.kind));
    one["tissue"] = library.title(event.tissue);
    one["depth"] = event.depth;
    one["value"] = event.value;
    events.append(std::move(one));
  }
  return events;
}

// The tick of one patient, whose data it owns.
class Tick {
 public:
  explicit Tick(std::shared_ptr<Patient> patient) : patient_(std::move(patient)) {
    const py::gil_scoped_release others_may_run;
    std::shared_ptr<const fem::ContactBody> whole;
    if (anatomy::body_of(patient_->data.description.haptics.resistance) != nullptr)
      patient::prepare_body(
          patient_->data, patient_->folder, {}, {}, [](const std::string&) {}, &whole);
    tick_.emplace(patient_->data);
    if (whole == nullptr) return;
    points_ = patient::contact_stream(patient_->data, patient_->data.prepared.path.length(), std::move(whole),
                                      tick_->body()->stream_points(simulation::BodyPort::PointTiming::in_time));
  }

  py::dict step(const Eigen::Matrix4d& pose) {
    const simulation::TickOutput output = tick_->step({.needle = pose_of(pose)});
    if (points_ != nullptr) points_->throw_failure();
    const anatomy::TissueLibrary& library = patient_->data.library;
    py::dict result;
    result["force"] = Vec3(output.applied.force);
    result["torque"] = Vec3(output.applied.torque);
    result["depth"] = output.depth;
    result["velocity"] = output.velocity;
    result["resistance"] = output.resistance;
    result["constraint"] = output.constraint;
    result["energy"] = output.energy;
    result["tissue"] = library.title(output.tissue);
    result["in_contact"] = output.in_contact;
    result["events"] = events_of(output, library);
    py::dict diagnostics;
    const auto names = tick_->diagnostic_names();
    for (std::size_t i = 0; i < names.size(); ++i)
      diagnostics[py::str(std::string(names[i].name))] = output.diagnostics[i];
    result["diagnostics"] = std::move(diagnostics);
    return result;
  }

  // Many ticks at once: columns of numbers, and the events with their ticks.
  py::dict run(const py::array_t<double, py::array::c_style | py::array::forcecast>& poses) {
    if (poses.ndim() != 3 || poses.shape(1) != 4 || poses.shape(2) != 4)
      throw InputError("run() takes an array of n x 4 x 4 numbers, one pose for each tick");
    const py::ssize_t count = poses.shape(0);
    py::array_t<double> force({count, py::ssize_t{3}}), depth(count), resistance(count), energy(count);
    py::array_t<int> tissue(count);
    py::list events;
    for (py::ssize_t i = 0; i < count; ++i) {
      const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> pose(poses.data(i, 0, 0));
      const simulation::TickOutput output = tick_->step({.needle = pose_of(pose)});
      for (int axis = 0; axis < 3; ++axis) force.mutable_at(i, axis) = output.applied.force[axis];
      depth.mutable_at(i) = output.depth;
      resistance.mutable_at(i) = output.resistance;
      energy.mutable_at(i) = output.energy;
      tissue.mutable_at(i) = output.tissue;
      for (const py::handle& event : events_of(output, patient_->data.library)) {
        event["tick"] = i;
        events.append(event);
      }
    }
    if (points_ != nullptr) points_->throw_failure();
    py::dict result;
    result["force"] = std::move(force);
    result["depth"] = std::move(depth);
    result["resistance"] = std::move(resistance);
    result["energy"] = std::move(energy);
    result["tissue"] = std::move(tissue);
    result["events"] = std::move(events);
    return result;
  }

  void reset() { tick_->reset(); }
  double dt() const { return tick_->dt(); }

 private:
  std::shared_ptr<Patient> patient_;
  std::optional<simulation::HapticTick> tick_;
  std::unique_ptr<fem::ContactStream> points_;  // of the needle's own lines in a deformable body
};

std::optional<std::pair<Vec3, Vec3>> path_of(const Patient& patient) {
  const auto& path = patient.data.description.procedure.path;
  if (!path) return std::nullopt;
  return std::pair{path->entry, path->target};
}

}  // namespace

}  // namespace bodkin::python

PYBIND11_MODULE(bodkin, module) {
  using namespace bodkin::python;
  module.doc() =
      "Needle insertion: patients and the haptic tick of Bodkin. Lengths in mm, times in s, forces in N, LPS.";
  py::register_exception<bodkin::InputError>(module, "InputError", PyExc_ValueError);
  py::class_<Patient, std::shared_ptr<Patient>>(module, "Case")
      .def_property_readonly("name", [](const Patient& patient) { return patient.data.description.name; })
      .def_property_readonly(
          "rate", [](const Patient& patient) { return patient.data.description.haptics.rate; }, "ticks per second")
      .def_property_readonly(
          "needle_length", [](const Patient& patient) { return patient.data.description.needle.length; }, "mm")
      .def_property_readonly("path", &path_of, "planned (entry, target), or None")
      .def(
          "tissue",
          [](const Patient& patient, int id) {
            return patient.data.library.title(static_cast<bodkin::anatomy::TissueId>(id));
          },
          py::arg("id"), "the title of a tissue number");
  module.def("load_case", &load_case, py::arg("folder"), py::arg("resistance") = "", py::arg("constraint") = "",
             py::arg("parts") = std::vector<std::string>(),
             "A case, with other force models where texts as those of 'bodkin run --resistance' are given.");
  module.def("needle_pose", &needle_pose, py::arg("tip"), py::arg("axis"),
             "The 4 x 4 pose of a needle with its tip there, pointing along axis.");
  py::class_<Tick>(module, "HapticTick")
      .def(py::init<std::shared_ptr<Patient>>(), py::arg("case"))
      .def("step", &Tick::step, py::arg("pose"), "One tick: the force on the hand and what was met, as a dict.")
      .def("run", &Tick::run, py::arg("poses"), "One tick for each of n poses: arrays, and the events.")
      .def("reset", &Tick::reset, "The needle is outside again, and nothing punctured.")
      .def_property_readonly("dt", &Tick::dt, "s between two ticks");
}
