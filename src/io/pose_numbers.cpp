#include "io/pose_numbers.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parse_numbers.h"
#include "io/xml_document.h"

namespace bodkin::io {

Pose pose_of_numbers(std::string_view text, const std::string& where) {
  constexpr double most_skew = 0.01;
  const std::string line = one_line(text);
  const std::vector<double> numbers = numbers_in(line);
  if (numbers.size() != 16) {
    throw InputError(fmt::format("{}: the transform is {}, expected 16 numbers, row by row", where, in_quotes(line)));
  }
  Pose pose = Pose::Identity();
  std::size_t next = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) pose.matrix()(row, column) = numbers[next++];
  }
  const Mat3 turn = pose.linear();
  if (!((turn.transpose() * turn - Mat3::Identity()).cwiseAbs().maxCoeff() <= 2.0 * most_skew) ||
      turn.determinant() < 0.0) {
    throw InputError(fmt::format(
        "{}: the transform {} is not a rotation and translation; expected one without scale, shear or mirror", where,
        in_quotes(line)));
  }
  pose.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  return pose;
}

std::string numbers_of_pose(const Pose& pose) {
  std::string text;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double value = pose.matrix()(row, column);
      fmt::format_to(std::back_inserter(text), "{}{:.9g}", text.empty() ? "" : " ", value == 0.0 ? 0.0 : value);
    }
  }
  return text;
}

void sort_by_time(PoseLog& log) {
  const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
  for (PoseTrack& track : log.tracks) {
    std::stable_sort(track.poses.begin(), track.poses.end(), earlier);
    std::vector<TimedPose> once;
    once.reserve(track.poses.size());
    for (const TimedPose& each : track.poses) {
      if (!once.empty() && once.back().time == each.time)
        once.back() = each;
      else
        once.push_back(each);
    }
    track.poses = std::move(once);
  }
  std::stable_sort(log.messages.begin(), log.messages.end(), earlier);
}

}  // namespace bodkin::io
