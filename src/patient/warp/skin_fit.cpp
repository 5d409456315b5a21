#include "patient/warp/skin_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellLocator.h>
#include <vtkIterativeClosestPointTransform.h>
#include <vtkLandmarkTransform.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkThinPlateSplineTransform.h>

#include "core/error.h"
#include "core/settings_check.h"

namespace bodkin::patient {

namespace {

constexpr double border = 4.0;     // mm from the end of a volume within which its surface is a lid
constexpr double farthest = 80.0;  // mm between two points that form a pair
constexpr double alike = 0.5;      // least cosine between the normals of a pair
constexpr std::size_t least_pairs = 12;
constexpr double depth_kept = 80.0;  // mm below the skin that move with it [D]

void fill(vtkPolyData& data, const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Vec3& vertex : vertices) points->InsertNextPoint(vertex.data());
  vtkNew<vtkCellArray> cells;
  for (const auto& corners : triangles) {
    const vtkIdType ids[3] = {corners[0], corners[1], corners[2]};
    cells->InsertNextCell(3, ids);
  }
  data.SetPoints(points);
  data.SetPolys(cells);
}

bool is_lid(const Skin& skin, const Vec3& place) {
  const Vec3 index = skin.grid.to_index(place);
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = border / skin.grid.spacing[axis];
    if (index[axis] < margin || index[axis] > skin.grid.size[static_cast<std::size_t>(axis)] - 1 - margin)
      return true;
  }
  return false;
}

std::vector<Vec3> normals_of(const anatomy::Surface& surface) {
  std::vector<Vec3> normals(surface.vertices().size(), Vec3::Zero());
  for (std::size_t t = 0; t < surface.triangles().size(); ++t) {
    const Vec3 normal = surface.normal(t);
    for (const int corner : surface.triangles()[t]) normals[static_cast<std::size_t>(corner)] += normal;
  }
  for (Vec3& normal : normals) normal.normalize();
  return normals;
}

// Finds the nearest place of a skin.
class NearestOnSkin {
 public:
  struct Place {
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
  };

  explicit NearestOnSkin(const Skin& skin) : skin_(skin) {
    fill(*data_, skin.surface.vertices(), skin.surface.triangles());
    locator_->SetDataSet(data_);
    locator_->BuildLocator();
  }
  Place find(const Vec3& from) const {
    Place place;
    vtkIdType cell = 0;
    int part = 0;
    double squared = 0.0;
    Vec3 query = from;
    locator_->FindClosestPoint(query.data(), place.point.data(), cell, part, squared);
    place.normal = skin_.surface.normal(static_cast<std::size_t>(cell));
    return place;
  }

 private:
  const Skin& skin_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkCellLocator> locator_;
};

SkinDistances distances_of(std::vector<double> lengths) {
  if (lengths.empty()) return {};
  std::sort(lengths.begin(), lengths.end());
  double sum = 0.0;
  for (const double length : lengths) sum += length * length;
  const auto count = lengths.size();
  return {std::sqrt(sum / static_cast<double>(count)), lengths[(count - 1) * 95 / 100], lengths.back()};
}

// Rigid, from points of the one skin to the surface of the other.
Pose closest_points(const std::vector<Vec3>& patient, const Skin& body, const Pose& start) {
  constexpr int most_iterations = 200, most_points = 4000;
  std::vector<Vec3> placed;
  placed.reserve(patient.size());
  for (const Vec3& point : patient) placed.push_back(start * point);
  vtkNew<vtkPolyData> from, to;
  fill(*from, placed, {});
  fill(*to, body.surface.vertices(), body.surface.triangles());
  vtkNew<vtkIterativeClosestPointTransform> icp;
  icp->SetSource(from);
  icp->SetTarget(to);
  icp->GetLandmarkTransform()->SetModeToRigidBody();
  icp->SetMaximumNumberOfIterations(most_iterations);
  icp->SetMaximumNumberOfLandmarks(most_points);
  icp->CheckMeanDistanceOn();
  icp->SetMaximumMeanDistance(1e-4);
  icp->Update();
  const vtkMatrix4x4* const found = icp->GetMatrix();
  Pose moved = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) moved.matrix()(row, column) = found->GetElement(row, column);
  }
  moved.linear() = Eigen::Quaterniond(moved.linear()).normalized().toRotationMatrix();
  return moved * start;
}

}  // namespace

void check(const SkinFitSettings& settings) {
  check_range("", "reach", settings.reach, {30.0, 500.0}, "mm");
  check_range("", "spacing", settings.spacing, {5.0, 60.0}, "mm");
}

struct SkinFit::Parts {
  Pose moved = Pose::Identity(), back = Pose::Identity();
  vtkNew<vtkThinPlateSplineTransform> spline;  // in the patient's axes, from before the skins were aligned to after
  std::size_t pairs = 0;
  SkinDistances at_start, when_moved, when_bent;

  Vec3 bent(const Vec3& place) const {
    Vec3 from = place, to = Vec3::Zero();
    spline->InternalTransformPoint(from.data(), to.data());
    return to;
  }
};

SkinFit::SkinFit(const Skin& patient, const Skin& body, const Pose& start, const Vec3& middle,
                 const SkinFitSettings& settings)
    : parts_(std::make_unique<Parts>()) {
  check(settings);
  Parts& parts = *parts_;
  const NearestOnSkin skin(patient);
  std::vector<Vec3> about;
  for (const Vec3& vertex : patient.surface.vertices()) {
    if ((vertex - middle).norm() <= settings.reach && !is_lid(patient, vertex)) about.push_back(vertex);
  }
  if (about.size() < least_pairs) {
    throw InputError(fmt::format("there is no skin of the patient within {:g} mm of the entry; give a larger reach",
                                 settings.reach));
  }
  parts.moved = closest_points(about, body, start);
  parts.back = parts.moved.inverse();

  // Points of the body's skin within reach, in the patient, each with its nearest place there.
  struct Pair {
    Vec3 body, patient, normal;
  };
  const std::vector<Vec3> normals = normals_of(body.surface);
  const Pose start_back = start.inverse();
  std::vector<Pair> pairs;
  std::vector<double> at_start, when_moved;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Vec3& vertex = body.surface.vertices()[i];
    const Vec3 placed = parts.back * vertex;
    if ((placed - middle).norm() > settings.reach || is_lid(body, vertex)) continue;
    const NearestOnSkin::Place nearest = skin.find(placed);
    const double distance = (nearest.point - placed).norm();
    if (distance > farthest || is_lid(patient, nearest.point) ||
        nearest.normal.dot(parts.back.linear() * normals[i]) < alike)
      continue;
    pairs.push_back({placed, nearest.point, nearest.normal});
    when_moved.push_back(distance);
    at_start.push_back((skin.find(start_back * vertex).point - start_back * vertex).norm());
  }
  parts.at_start = distances_of(std::move(at_start));
  parts.when_moved = distances_of(std::move(when_moved));

  // Keeps the first of them in each cube.
  const auto thinned = [&](double spacing) {
    std::map<std::tuple<int, int, int>, std::size_t> in_cube;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Vec3 cube = (pairs[i].body / spacing).array().floor();
      in_cube.emplace(std::tuple{static_cast<int>(cube.x()), static_cast<int>(cube.y()), static_cast<int>(cube.z())},
                      i);
    }
    return in_cube;
  };
  const auto chosen = thinned(settings.spacing), fewer = thinned(2.0 * settings.spacing);
  parts.pairs = chosen.size();
  if (parts.pairs < least_pairs) {
    throw InputError(fmt::format(
        "only {} places of both skins lie together within {:g} mm, expected {} or more; register the patient to the "
        "mannequin first (--registration), or give a larger reach or a smaller spacing",
        parts.pairs, settings.reach, least_pairs));
  }
  vtkNew<vtkPoints> from, to;
  from->SetDataTypeToDouble();
  to->SetDataTypeToDouble();
  Vec3 outwards = Vec3::Zero();
  for (const auto& [cube, i] : chosen) outwards += pairs[i].normal;
  outwards.normalize();
  // Skin contains no information about deeper tissue: without points there the spline would stretch the depth.
  for (const double below : {0.0, 0.5 * depth_kept, depth_kept}) {
    for (const auto& [cube, i] : below < depth_kept ? chosen : fewer) {
      const Vec3 before = pairs[i].body - below * outwards, after = pairs[i].patient - below * outwards;
      from->InsertNextPoint(before.data());
      to->InsertNextPoint(after.data());
    }
  }
  parts.spline->SetBasisToR();
  parts.spline->SetSourceLandmarks(from);
  parts.spline->SetTargetLandmarks(to);
  parts.spline->Update();
  std::vector<double> when_bent;
  for (const Pair& pair : pairs) {
    const Vec3 place = parts.bent(pair.body);
    when_bent.push_back((skin.find(place).point - place).norm());
  }
  parts.when_bent = distances_of(std::move(when_bent));
}

SkinFit::~SkinFit() = default;
SkinFit::SkinFit(SkinFit&&) noexcept = default;
SkinFit& SkinFit::operator=(SkinFit&&) noexcept = default;

Vec3 SkinFit::to_patient(const Vec3& place) const {
  return parts_->bent(parts_->back * place);
}

// The bend is gentle: a few steps of the same map invert it.
Vec3 SkinFit::to_body(const Vec3& place) const {
  constexpr int most_steps = 100;
  constexpr double enough = 1e-6;  // mm
  Vec3 guess = place;
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 missed = place - parts_->bent(guess);
    guess += missed;
    if (missed.norm() < enough) break;
  }
  return parts_->moved * guess;
}

const Pose& SkinFit::moved() const noexcept {
  return parts_->moved;
}
std::size_t SkinFit::pairs() const noexcept {
  return parts_->pairs;
}
SkinDistances SkinFit::at_start() const noexcept {
  return parts_->at_start;
}
SkinDistances SkinFit::when_moved() const noexcept {
  return parts_->when_moved;
}
SkinDistances SkinFit::when_bent() const noexcept {
  return parts_->when_bent;
}

}  // namespace bodkin::patient
