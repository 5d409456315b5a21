#include "fem/contact_line.h"

#include <algorithm>

namespace bodkin::fem {

namespace {

constexpr std::uint64_t complete_bit = std::uint64_t{1} << 31U, points_mask = complete_bit - 1;

}  // namespace

ContactLine::ContactLine(double spring, std::size_t most_held)
    : spring_(spring), newest_{.held = std::vector<std::uint32_t>(most_held, 0)}, wanted_(newest_) {
  body_.nodes.resize(most_points, Vec3::Zero());
  body_.tissues.resize(most_points, anatomy::tissue::air);
  body_.in_mesh.resize(most_points);
  for (std::vector<HeldFraction>& shares : on_held_) shares.resize(most_points);
  constexpr auto size = static_cast<Eigen::Index>(3 * most_points);
  body_.compliance = Eigen::MatrixXd::Zero(size, size);
  if (most_held > 0) other_ = body_.compliance;
}

void ContactLine::request(const Vec3& entry, const Vec3& direction, std::span<const std::uint32_t> held) noexcept {
  newest_.entry = entry;
  newest_.direction = direction;
  newest_.kept = 0;
  newest_.is_planned = false;
  newest_.is_coupling = false;
  newest_.held_count = std::min(held.size(), newest_.held.size());
  std::copy_n(held.begin(), newest_.held_count, newest_.held.begin());
  request_newest();
}

void ContactLine::request_planned(const Vec3& entry, const Vec3& direction) noexcept {
  newest_.entry = entry;
  newest_.direction = direction;
  newest_.kept = 0;
  newest_.is_planned = true;
  newest_.is_coupling = false;
  newest_.held_count = 0;
  request_newest();
}

void ContactLine::continue_from(const Vec3& place, const Vec3& direction, std::size_t kept) noexcept {
  newest_.entry = place;
  newest_.direction = direction;
  newest_.kept = kept;
  newest_.is_coupling = false;
  request_newest();
}

void ContactLine::couple(std::span<const std::uint32_t> held, std::size_t points) noexcept {
  newest_.kept = points;
  newest_.is_coupling = true;
  newest_.held_count = std::min(held.size(), newest_.held.size());
  std::copy_n(held.begin(), newest_.held_count, newest_.held.begin());
  request_newest();
}

bool ContactLine::is_coupled() const noexcept {
  return coupled_.load(std::memory_order_acquire) == 2 * std::uint64_t{newest_.number};
}

bool ContactLine::wait_until_coupled() const noexcept {
  for (;;) {
    const std::uint64_t seen = coupled_.load(std::memory_order_acquire);
    if (seen / 2 == newest_.number || requested_.load(std::memory_order_relaxed) == closed) return is_coupled();
    coupled_.wait(seen, std::memory_order_acquire);
  }
}

void ContactLine::apply_coupling() noexcept {
  turn_ = 1 - turn_;
}

void ContactLine::request_newest() noexcept {
  std::uint64_t before = requested_.load(std::memory_order_relaxed);
  if (before == closed) return;
  newest_.number = static_cast<std::uint32_t>(before + 1);
  newest_.turn = newest_.is_coupling ? 1 - turn_ : turn_;
  wanted_.write(newest_);
  // Fails only if the line has been closed meanwhile.
  if (requested_.compare_exchange_strong(before, newest_.number, std::memory_order_acq_rel)) requested_.notify_all();
}

ContactLine::Progress ContactLine::progress() const noexcept {
  const std::uint64_t requested = requested_.load(std::memory_order_relaxed);
  const std::uint64_t now = progress_.load(std::memory_order_acquire);
  if (now >> 32U != requested) return {0, requested == closed};
  return {static_cast<std::size_t>(now & points_mask), (now & complete_bit) != 0};
}

Wrench ContactLine::on_held(const NodeForces& forces) const noexcept {
  Wrench sum;
  for (std::size_t i = 0; i < forces.count; ++i) {
    const NodeForce& one = forces.nodes[i];
    if (one.node >= most_points) continue;
    const Vec3 force = Eigen::Map<const Eigen::Vector3f>(one.force.data()).cast<double>();
    sum.force += on_held_[turn_][one.node].force * force;
    sum.torque += on_held_[turn_][one.node].torque * force;
  }
  return sum;
}

ContactLine::Progress ContactLine::wait_for(std::size_t points) const noexcept {
  for (;;) {
    const std::uint64_t seen = progress_.load(std::memory_order_acquire);
    const Progress now = progress();
    if (now.complete || now.points >= points) return now;
    progress_.wait(seen, std::memory_order_acquire);
  }
}

std::optional<ContactLine::Line> ContactLine::next_line() noexcept {
  for (;;) {
    const std::uint64_t now = requested_.load(std::memory_order_acquire);
    if (now == closed) return {};
    if (now > served_) {
      const Line line = wanted_.read();  // this one, or the next one requested
      served_ = line.number;
      const std::uint64_t complete = line.is_coupling ? complete_bit : 0;
      progress_.store(std::uint64_t{line.number} << 32U | complete | line.kept, std::memory_order_release);
      return line;
    }
    requested_.wait(now, std::memory_order_acquire);
  }
}

bool ContactLine::append(const Line& line, const ContactPoint& point) noexcept {
  const std::uint64_t now = progress_.load(std::memory_order_relaxed);
  const auto at = static_cast<std::size_t>(now & points_mask);
  if (requested_.load(std::memory_order_acquire) > line.number || at == most_points || point.between.size() != at + 1)
    return false;
  write(line, at, point);
  progress_.store(now + 1, std::memory_order_release);
  progress_.notify_all();
  return true;
}

void ContactLine::write(const Line& line, std::size_t at, const ContactPoint& point) noexcept {
  if (!line.is_coupling) {
    body_.nodes[at] = point.place;
    body_.tissues[at] = point.tissue;
    body_.in_mesh[at] = point.in_mesh;
  }
  on_held_[line.turn][at] = point.on_held;
  Eigen::MatrixXd& compliance = line.turn == 0 ? body_.compliance : other_;
  const auto column = static_cast<Eigen::Index>(3 * at);
  for (std::size_t i = 0; i <= at; ++i) {
    const auto row = static_cast<Eigen::Index>(3 * i);
    const Mat3 between = point.between[i] + spring_ * Mat3::Identity();
    compliance.block<3, 3>(row, column) = between;
    compliance.block<3, 3>(column, row) = between.transpose();
  }
}

bool ContactLine::put(const Line& line, std::size_t at, const ContactPoint& point) noexcept {
  if (requested_.load(std::memory_order_acquire) > line.number || at >= most_points || point.between.size() != at + 1)
    return false;
  write(line, at, point);
  return true;
}

void ContactLine::end_coupling(const Line& line, bool done) noexcept {
  coupled_.store(2 * std::uint64_t{line.number} + (done ? 0 : 1), std::memory_order_release);
  coupled_.notify_all();
}

void ContactLine::complete(const Line& line) noexcept {
  const std::uint64_t now = progress_.load(std::memory_order_relaxed);
  if (now >> 32U != line.number) return;
  progress_.store(now | complete_bit, std::memory_order_release);
  progress_.notify_all();
}

void ContactLine::close() noexcept {
  requested_.store(closed, std::memory_order_release);
  requested_.notify_all();
  // Values that differ, so that waiting ends.
  progress_.fetch_xor(std::uint64_t{1} << 63U, std::memory_order_acq_rel);
  progress_.notify_all();
  coupled_.fetch_xor(std::uint64_t{1} << 63U, std::memory_order_acq_rel);
  coupled_.notify_all();
}

}  // namespace bodkin::fem
