#include "tracking/body_calibration.h"

#include <array>
#include <cmath>
#include <utility>

#include "tracking/marker_search.h"
#include "tracking/start_pose.h"
#include <Eigen/Cholesky>
#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::tracking {

namespace {

constexpr double most_face_residual = 0.06;

// Effect of a shift and rotation of the body, in camera axes, on a face whose origin lies at `arm` from the body's.
Matrix6 moved_by_body(const Vec3& arm) {
  Matrix6 slope = Matrix6::Identity();
  slope(0, 4) = arm.z();
  slope(0, 5) = -arm.y();
  slope(1, 3) = -arm.z();
  slope(1, 5) = arm.x();
  slope(2, 3) = arm.y();
  slope(2, 4) = -arm.x();
  return slope;
}

}  // namespace

BodyCalibration::BodyCalibration(const CameraModel& camera, MarkerBody body)
    : body_(std::move(body)), refinement_(camera) {}

int BodyCalibration::add(const GreyImage& picture) {
  const std::vector<FoundMarker> found = search_markers(picture);
  const std::vector<StartPose> starts = start_poses(refinement_.camera(), body_, found);
  std::vector<Seen> seen;
  if (starts.empty()) return 0;
  for (const FoundMarker& marker : found) {
    for (std::size_t f = 0; f < body_.faces.size(); ++f) {
      if (body_.faces[f].id != marker.id) continue;
      MarkerBody alone;
      alone.faces = {body_.faces[f]};
      alone.faces.front().place = Pose::Identity();
      const std::array<int, 1> ids = {marker.id};
      const Pose start = starts.front().camera_from_body * body_.faces[f].place;
      const RefinedPose refined = refinement_.refine(picture, alone, ids, start, 8);
      if (!refined.sound || refined.residual > most_face_residual) continue;
      // The other planar solution is far from the body's pose.
      if (Eigen::AngleAxisd(refined.camera_from_body.linear().transpose() * start.linear()).angle() > 6.0 * degree)
        continue;
      seen.push_back({f, refined.camera_from_body, inverse_of(refined.covariance)});
    }
  }
  const int faces = static_cast<int>(seen.size());
  if (faces >= 2) pictures_.push_back(std::move(seen));
  return faces;
}

CalibratedBody BodyCalibration::solve(int least) const {
  CalibratedBody made;
  made.body = body_;
  made.pictures = static_cast<int>(pictures_.size());
  std::vector<int> unknown_of(body_.faces.size(), -1);  // the first marked face has none
  std::vector<int> times(body_.faces.size(), 0);
  for (const auto& picture : pictures_) {
    for (const Seen& seen : picture) ++times[seen.face];
  }
  int unknowns = 0;
  bool first = true;
  for (std::size_t f = 0; f < body_.faces.size(); ++f) {
    if (body_.faces[f].id < 0) continue;
    if (times[f] < least) {
      throw InputError(
          fmt::format("marker {} of body \"{}\" was seen together with another one in {} pictures; {} are needed, so "
                      "turn it towards the camera more often",
                      body_.faces[f].id, body_.name, times[f], least));
    }
    if (!first) unknown_of[f] = 6 * unknowns++;
    first = false;
  }
  std::vector<Pose> bodies;
  for (const auto& picture : pictures_)
    bodies.push_back(picture.front().camera_from_face * body_.faces[picture.front().face].place.inverse());
  Eigen::MatrixXd covariance;
  for (int turn = 0; turn < 12; ++turn) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(6 * unknowns, 6 * unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(6 * unknowns);
    struct Part {
      int unknown;
      Matrix6 across;  // of face and body
    };
    std::vector<std::vector<Part>> parts(pictures_.size());
    std::vector<Matrix6> inverses(pictures_.size());
    std::vector<Vector6> rights(pictures_.size());
    for (std::size_t k = 0; k < pictures_.size(); ++k) {
      Matrix6 of_body = Matrix6::Zero();
      Vector6 of_body_right = Vector6::Zero();
      const Mat3 axes = bodies[k].linear();
      Matrix6 by_face = Matrix6::Zero();
      by_face.topLeftCorner<3, 3>() = by_face.bottomRightCorner<3, 3>() = axes;
      for (const Seen& seen : pictures_[k]) {
        const Pose expected = bodies[k] * made.body.faces[seen.face].place;
        const Vector6 off = step_between(expected, seen.camera_from_face);
        const Matrix6 by_body = moved_by_body(expected.translation() - bodies[k].translation());
        of_body += by_body.transpose() * seen.information * by_body;
        of_body_right += by_body.transpose() * seen.information * off;
        const int u = unknown_of[seen.face];
        if (u < 0) continue;
        normal.block<6, 6>(u, u) += by_face.transpose() * seen.information * by_face;
        right.segment<6>(u) += by_face.transpose() * seen.information * off;
        parts[k].push_back({u, by_face.transpose() * seen.information * by_body});
      }
      inverses[k] = inverse_of(of_body);
      rights[k] = of_body_right;
      for (const Part& a : parts[k]) {
        right.segment<6>(a.unknown) -= a.across * inverses[k] * of_body_right;
        for (const Part& b : parts[k])
          normal.block<6, 6>(a.unknown, b.unknown) -= a.across * inverses[k] * b.across.transpose();
      }
    }
    const Eigen::LDLT<Eigen::MatrixXd> solved(normal);
    const Eigen::VectorXd step = solved.solve(right);
    covariance = solved.solve(Eigen::MatrixXd::Identity(6 * unknowns, 6 * unknowns));
    for (std::size_t k = 0; k < pictures_.size(); ++k) {
      Vector6 left_over = rights[k];
      for (const Part& part : parts[k]) left_over -= part.across.transpose() * step.segment<6>(part.unknown);
      take_step(bodies[k], inverses[k] * left_over);
    }
    for (std::size_t f = 0; f < made.body.faces.size(); ++f) {
      if (unknown_of[f] >= 0) take_step(made.body.faces[f].place, step.segment<6>(unknown_of[f]));
    }
    if (step.norm() < 1e-7) break;
  }
  for (std::size_t f = 0; f < made.body.faces.size(); ++f) {
    if (made.body.faces[f].id < 0) continue;
    CalibratedFace face;
    face.id = made.body.faces[f].id;
    face.pictures = times[f];
    const Vector6 change = step_between(body_.faces[f].place, made.body.faces[f].place);
    face.moved = change.head<3>().norm();
    face.turned = change.tail<3>().norm() / degree;
    if (const int u = unknown_of[f]; u >= 0) {
      face.deviation = std::sqrt(covariance.block<3, 3>(u, u).trace());
      face.angle_deviation = std::sqrt(covariance.block<3, 3>(u + 3, u + 3).trace()) / degree;
    }
    made.faces.push_back(face);
  }
  return made;
}

}  // namespace bodkin::tracking
