#include "station/ultrasound_choice.h"

#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::station {

namespace {

constexpr double rigid_enough = 1e-3;  // by which a rotation's columns may deviate from unit length and right angles

}  // namespace

imaging::ProbeOnSkin hold_probe(const UltrasoundChoice& choice, const anatomy::Case& patient) {
  if (choice.pose) {
    imaging::ProbeOnSkin hand(*choice.pose);
    hand.press(choice.press);
    return hand;
  }
  imaging::ScanRequest request = choice.request;
  if (!choice.at_name.empty()) {
    request.at = imaging::place_named(patient, choice.at_name);
    if (!request.at) {
      throw InputError(
          fmt::format("--at is '{}', which is not a landmark or structure of the case; expected one of them ('bodkin "
                      "case show' names "
                      "them) or x,y,z in LPS mm",
                      choice.at_name));
    }
  }
  imaging::ProbeOnSkin hand = imaging::place_probe(patient, choice.probe, request);
  hand.press(choice.press);
  return hand;
}

imaging::NeedleInUltrasound needle_on_path(const anatomy::Case& patient, const std::optional<double>& depth) {
  const std::optional<anatomy::NeedlePath>& path = patient.description.procedure.path;
  if (!path) throw InputError("the case has no planned path for --needle; make one with --entry and --target");
  const double inside = depth.value_or(path->length());
  return {needle_pose(path->entry + inside * path->direction(), path->direction()), patient.description.needle};
}

Pose parse_pose(const std::vector<double>& numbers, const std::string& origin) {
  Pose pose = Pose::Identity();
  std::size_t next = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) pose.matrix()(row, column) = numbers.at(next++);
  }
  const bool last_row =
      numbers.size() != 16 || (numbers[12] == 0.0 && numbers[13] == 0.0 && numbers[14] == 0.0 && numbers[15] == 1.0);
  const Mat3 turn = pose.linear();
  const bool rigid = (turn.transpose() * turn - Mat3::Identity()).cwiseAbs().maxCoeff() < rigid_enough;
  if (!rigid || !last_row || turn.determinant() < 0.0 || !pose.matrix().allFinite()) {
    throw InputError(fmt::format(
        "{} is not a rigid placement, expected a rotation without scaling or mirroring, with the place in "
        "mm in the fourth "
        "column",
        origin));
  }
  pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();  // restores digits lost in a text
  return pose;
}

std::string pose_text(const Pose& pose) {
  std::string text;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double value = pose.matrix()(row, column);
      text += fmt::format("{}{:.6g}", text.empty() ? "" : ",", value == 0.0 ? 0.0 : value);
    }
  }
  return text;
}

}  // namespace bodkin::station
