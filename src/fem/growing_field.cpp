#include "fem/growing_field.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace bodkin::fem {

namespace {

constexpr std::size_t asked_at_once = 8;
constexpr std::uint32_t no_place = 0xffffffff;

}  // namespace

GrowingField::GrowingField(DisplayField field)
    : field_(std::move(field)), place_of_(field_.all(), no_place), spare_of_(field_.all(), no_place) {}

GrowingField::GrowingField(DisplayField field, Columns columns, std::span<const std::uint32_t> node_points)
    : field_(std::move(field)),
      columns_(std::move(columns)),
      place_of_(field_.all(), no_place),
      needed_(field_.spare(), 0),
      spare_of_(field_.all(), no_place),
      thread_([this](const std::stop_token& stop) { run(stop); }) {
  std::size_t place = field_.points() - node_points.size();
  for (const std::uint32_t node : node_points) place_of_[node] = static_cast<std::uint32_t>(place++);
}

GrowingField::~GrowingField() = default;

void GrowingField::run(const std::stop_token& stop) {
  std::unique_lock guard(lock_);
  while (changed_.wait(guard, stop, [this] { return request_ == Request::asked; })) {
    const std::vector<std::uint32_t> nodes = asked_;
    guard.unlock();
    Eigen::MatrixXf found;
    bool failed = false;
    try {
      found = columns_(nodes);
    } catch (const std::exception&) {
      failed = true;  // no memory: the display continues with the existing columns
    }
    guard.lock();
    found_ = std::move(found);
    request_ = failed ? Request::failed : Request::found;
  }
}

void GrowingField::hold(std::span<const std::uint32_t> nodes) {
  std::vector<std::uint32_t> held;
  for (const std::uint32_t node : nodes)
    if (node < place_of_.size() && place_of_[node] != no_place) held.push_back(node);
  if (held == held_) return;
  held_ = std::move(held);
  held_factor_ = {};
}

void GrowingField::evaluate(const NodeForces& forces, std::span<float> displacements) {
  ++round_;
  missing_.clear();
  for (std::size_t i = 0; i < std::min(forces.count, NodeForces::capacity); ++i) need(forces.nodes[i].node);
  if (forces.count > 0)
    for (const std::uint32_t node : held_) need(node);
  take_found();
  ask();
  field_.evaluate(forces, displacements);
  if (forces.count > 0 && !held_.empty()) hold_still(displacements);
}

void GrowingField::need(std::uint32_t node) {
  if (node >= field_.all()) return;
  if (spare_of_[node] != no_place) needed_[spare_of_[node]] = round_;
  if (!field_.knows(node)) missing_.push_back(node);
}

// Into the least recently used places, except those needed now.
void GrowingField::take_found() {
  const std::lock_guard guard(lock_);
  if (request_ != Request::found) return;
  request_ = Request::none;
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    const auto oldest = std::ranges::min_element(needed_);
    if (oldest == needed_.end() || *oldest == round_) return;
    const auto place = static_cast<std::size_t>(oldest - needed_.begin());
    const std::uint32_t node = asked_[i];
    std::ranges::replace(spare_of_, static_cast<std::uint32_t>(place), no_place);
    field_.take(place, node, found_.middleCols<3>(static_cast<Eigen::Index>(3 * i)));
    spare_of_[node] = static_cast<std::uint32_t>(place);
    *oldest = round_;
    std::erase(missing_, node);
  }
}

// At most as many as there are places not needed now.
void GrowingField::ask() {
  const auto room =
      static_cast<std::size_t>(std::ranges::count_if(needed_, [this](auto at) { return at != round_; }));
  if (missing_.empty() || room == 0) return;
  const std::lock_guard guard(lock_);
  if (request_ != Request::none) return;
  asked_.clear();
  for (const std::uint32_t node : missing_) {
    if (asked_.size() == std::min(room, asked_at_once)) break;
    if (std::ranges::find(asked_, node) == asked_.end()) asked_.push_back(node);
  }
  request_ = Request::asked;
  changed_.notify_one();
}

// S_hh^-1, once all of their columns are available.
bool GrowingField::solve_held() {
  if (held_factor_.cols() > 0) return held_factor_.info() == Eigen::Success;
  const auto size = static_cast<Eigen::Index>(3 * held_.size());
  Eigen::MatrixXd between(size, size);
  for (std::size_t b = 0; b < held_.size(); ++b) {
    if (!field_.knows(held_[b])) return false;
    for (std::size_t a = 0; a < held_.size(); ++a)
      between.block<3, 3>(static_cast<Eigen::Index>(3 * a), static_cast<Eigen::Index>(3 * b)) =
          field_.between(place_of_[held_[a]], held_[b]);
  }
  held_factor_.compute(0.5 * (between + between.transpose()));
  return held_factor_.info() == Eigen::Success;
}

void GrowingField::hold_still(std::span<float> displacements) {
  if (held_.size() > NodeForces::capacity || displacements.size() < 3 * points() || !solve_held()) return;
  Eigen::VectorXd moved(static_cast<Eigen::Index>(3 * held_.size()));
  for (std::size_t i = 0; i < held_.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      moved(static_cast<Eigen::Index>(3 * i + c)) =
          static_cast<double>(displacements[3 * std::size_t{place_of_[held_[i]]} + c]);
  const Eigen::VectorXd by_holder = -held_factor_.solve(moved);
  of_holder_.count = held_.size();
  for (std::size_t i = 0; i < held_.size(); ++i) {
    NodeForce& here = of_holder_.nodes[i];
    here.node = held_[i];
    for (std::size_t c = 0; c < 3; ++c)
      here.force[c] = static_cast<float>(by_holder(static_cast<Eigen::Index>(3 * i + c)));
  }
  by_holder_.resize(3 * points());
  field_.evaluate(of_holder_, by_holder_);
  for (std::size_t i = 0; i < by_holder_.size(); ++i) displacements[i] += by_holder_[i];
}

}  // namespace bodkin::fem
