#include "fem/moving/corotational_body.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "core/settings_check.h"
#include "fem/solid/element_stiffness.h"

namespace bodkin::fem {

namespace {

constexpr int most_halvings = 8;
constexpr double farthest_step = 1e4;          // mm; beyond, the computation has failed
constexpr double tonnes_per_cubic_mm = 1e-12;  // of 1 kg/m^3

const BodyDescription& checked_moving_body(const BodyDescription& body) {
  check_body(body);
  if (const auto tissue = tissue_with_fibres(body.mesh, body.materials)) {
    throw InputError(
        fmt::format("tissue {} has fibres, which a moving body does not support; leave the fibres out of "
                    "its entry in tissues.xml, or let the body lie still (without --body moving)",
                    *tissue));
  }
  return body;
}

CorotationalSettings checked_corotational_settings(const CorotationalSettings& settings) {
  constexpr auto origin = "moving body";
  if (settings.dt != 0.0) check_range(origin, "step", settings.dt, {1e-5, 1.0}, "s");
  check_range(origin, "density", settings.density, {1.0, 30000.0}, "kg/m^3");
  check_range(origin, "damping by mass", settings.mass_damping, {0.0, 1000.0}, "1/s");
  check_range(origin, "damping by stiffness", settings.stiffness_damping, {0.0, 1.0}, "s");
  check_range(origin, "tolerance of conjugate gradients", settings.gradients.tolerance, {1e-14, 0.5}, "");
  check_range(origin, "number of iterations", settings.gradients.most_iterations, {1.0, 1e6}, "");
  check_range(origin, "number of corrections", settings.most_corrections, {1.0, 50.0}, "");
  check_range(origin, "balance", settings.balance, {0.0, 1e3}, "N");
  return settings;
}

double largest_column(const NodeVectors& vectors) noexcept {
  double largest = 0.0;
  for (Eigen::Index node = 0; node < vectors.cols(); ++node)
    largest = std::max(largest, vectors.col(node).squaredNorm());
  return std::sqrt(largest);
}

}  // namespace

CorotationalBody::CorotationalBody(const BodyDescription& body, const CorotationalSettings& settings,
                                   std::span<const anatomy::NeedlePath> left)
    : settings_(checked_corotational_settings(settings)),
      elements_(checked_moving_body(body).mesh, body.materials),
      needles_(body.mesh, body.materials, left),
      matrix_(body.mesh),
      gradients_(body.mesh.nodes.size()),
      masses_(body.mesh.nodes.size(), 0.0),
      inertia_(body.mesh.nodes.size(), 0.0),
      held_(body.mesh.nodes.size(), 0) {
  const anatomy::TetrahedralMesh& mesh = body.mesh;
  for (const std::uint32_t node : body.fixed) held_[node] = 2;
  for (const auto& element : mesh.elements) {
    const double volume = tetrahedron_gradients({mesh.nodes[element[0]], mesh.nodes[element[1]],
                                                 mesh.nodes[element[2]], mesh.nodes[element[3]]})
                              .volume;
    for (const std::uint32_t node : element) masses_[node] += 0.25 * volume * tonnes_per_cubic_mm * settings_.density;
  }
  if (settings_.dt > 0.0) {
    const double by = (1.0 / settings_.dt + settings_.mass_damping) / settings_.dt;
    for (std::size_t node = 0; node < masses_.size(); ++node) inertia_[node] = masses_[node] * by;
  }
  diagonal_ = inertia_;
  needles_.add_stiffness(diagonal_);
  const auto count = static_cast<Eigen::Index>(mesh.nodes.size());
  for (NodeVectors* vector : {&rest_, &places_, &velocities_, &goals_, &forces_, &loads_, &begin_, &begin_forces_,
                              &push_, &moved_, &product_, &before_, &change_, &residual_})
    vector->setZero(4, count);
  for (Eigen::Index node = 0; node < count; ++node)
    rest_.col(node).head<3>() = mesh.nodes[static_cast<std::size_t>(node)];
  reset();
}

void CorotationalBody::reset() noexcept {
  for (std::uint8_t& held : held_) held = held == 2 ? 2 : 0;
  places_ = goals_ = rest_;
  velocities_.setZero();
  loads_.setZero();
  elements_.reset();
  energy_ = evaluate();
  reported_ = {};
}

// Forces and energy at places_.
double CorotationalBody::evaluate() noexcept {
  const double energy = elements_.evaluate(places_, forces_);
  return energy + needles_.add_forces(places_, forces_);
}

bool CorotationalBody::place(const Eigen::Matrix3Xd& places) noexcept {
  if (places.cols() != places_.cols() || !places.allFinite()) return false;
  for (Eigen::Index node = 0; node < places.cols(); ++node)
    if (held_[static_cast<std::size_t>(node)] == 0) places_.col(node).head<3>() = places.col(node);
  velocities_.setZero();
  energy_ = evaluate();
  return true;
}

void CorotationalBody::hold(std::uint32_t node, const Vec3& place) noexcept {
  if (node >= held_.size() || held_[node] == 2 || !place.allFinite()) return;
  held_[node] = 1;
  goals_.col(node).head<3>() = place;
}

void CorotationalBody::release(std::uint32_t node) noexcept {
  if (node < held_.size() && held_[node] == 1) held_[node] = 0;
}

void CorotationalBody::load(std::uint32_t node, const Vec3& force) noexcept {
  if (node < held_.size() && force.allFinite()) loads_.col(node).head<3>() += force;
}

double CorotationalBody::kinetic_energy() const noexcept {
  double sum = 0.0;
  for (std::size_t node = 0; node < masses_.size(); ++node)
    sum += 0.5 * masses_[node] * velocities_.col(static_cast<Eigen::Index>(node)).squaredNorm();
  return sum;
}

// b / dt, the damping's contribution to the stiffness.
double CorotationalBody::damping_share() const noexcept {
  return settings_.dt > 0.0 ? settings_.stiffness_damping / settings_.dt : 0.0;
}

// sum += `share` of the matrix's diagonal, minus the forces of masses and their damping against `moved`.
void CorotationalBody::add_diagonals(const NodeVectors& moved, double share, NodeVectors& sum) const noexcept {
  for (Eigen::Index node = 0; node < moved.cols(); ++node) {
    const auto i = static_cast<std::size_t>(node);
    const double needles = diagonal_[i] - inertia_[i];
    sum.col(node) += ((share - 1.0) * inertia_[i] + share * needles) * moved.col(node);
  }
}

void CorotationalBody::begin_step() noexcept {
  reported_ = {};
  begin_ = places_;
  begin_forces_ = forces_;
  begin_energy_ = energy_;
  push_ = loads_;
  if (settings_.dt > 0.0) {
    for (Eigen::Index node = 0; node < push_.cols(); ++node)
      push_.col(node) += masses_[static_cast<std::size_t>(node)] / settings_.dt * velocities_.col(node);
  }
  matrix_.assemble(elements_.turned(), 1.0 + damping_share(), diagonal_);
  matrix_.invert_diagonal(held_);
  moved_.setZero();
  for (Eigen::Index node = 0; node < moved_.cols(); ++node)
    if (held_[static_cast<std::size_t>(node)] == 1) moved_.col(node) = goals_.col(node) - begin_.col(node);
  matrix_.multiply(moved_, product_);
  residual_ = push_ + begin_forces_ - product_;
}

// Change so far in the energy that implicit Euler minimises; at most 0 if no motion is imposed.
double CorotationalBody::energy_won() const noexcept {
  double inertia = 0.0, diagonal = 0.0;
  for (Eigen::Index node = 0; node < moved_.cols(); ++node) {
    const double square = moved_.col(node).squaredNorm();
    inertia += inertia_[static_cast<std::size_t>(node)] * square;
    diagonal += diagonal_[static_cast<std::size_t>(node)] * square;
  }
  const double share = damping_share();
  const double stiff = (moved_.cwiseProduct(product_).sum() - diagonal) / (1.0 + share);
  return energy_ - begin_energy_ + 0.5 * inertia + 0.5 * share * stiff - push_.cwiseProduct(moved_).sum();
}

// The residual force on the free nodes.
void CorotationalBody::find_residual() noexcept {
  const double share = damping_share() / (1.0 + damping_share());
  residual_ = push_ + forces_ - share * product_;
  add_diagonals(moved_, share, residual_);
  for (Eigen::Index node = 0; node < residual_.cols(); ++node)
    if (held_[static_cast<std::size_t>(node)] != 0) residual_.col(node).setZero();
  reported_.unbalance = largest_column(residual_);
}

// A Newton step for the residual, halved until the energy is at most `won`, the value so far.
bool CorotationalBody::correct(double& won) noexcept {
  before_ = moved_;
  reported_.iterations += gradients_.solve(matrix_, residual_, settings_.gradients, change_);
  ++reported_.corrections;
  for (int halving = 0;; ++halving) {
    moved_ = before_ + change_;
    places_ = begin_ + moved_;
    matrix_.multiply(moved_, product_);
    energy_ = evaluate();
    const double now = energy_won();
    const bool finite = std::isfinite(now) && forces_.allFinite() && largest_column(moved_) < farthest_step;
    const double rounding = 1e-12 * (std::abs(energy_) + std::abs(begin_energy_));
    if ((finite && now <= won + rounding) || halving == most_halvings) {
      won = now;
      return finite;
    }
    change_ *= 0.5;
    ++reported_.halvings;
  }
}

void CorotationalBody::go_back() noexcept {
  places_ = begin_;
  velocities_.setZero();
  energy_ = evaluate();
  reported_.fault = true;
  reported_.largest_move = 0.0;
}

const CorotationalStep& CorotationalBody::step() noexcept {
  begin_step();
  // Of the held nodes only, in the linear body: the bound for the energy after the first Newton step.
  double won = 0.5 * moved_.cwiseProduct(product_).sum() - (push_ + begin_forces_).cwiseProduct(moved_).sum();
  change_.setZero();
  if (settings_.dt > 0.0) {  // first guess: constant velocity
    for (Eigen::Index node = 0; node < change_.cols(); ++node)
      if (held_[static_cast<std::size_t>(node)] == 0) change_.col(node) = settings_.dt * velocities_.col(node);
  }
  do {
    if (!correct(won)) {
      go_back();
      return reported_;
    }
    find_residual();
    change_.setZero();
  } while (reported_.corrections < settings_.most_corrections && reported_.unbalance > settings_.balance);
  if (settings_.dt > 0.0) velocities_ = moved_ / settings_.dt;
  reported_.largest_move = largest_column(moved_);
  return reported_;
}

}  // namespace bodkin::fem
