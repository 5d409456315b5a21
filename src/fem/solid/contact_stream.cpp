#include "fem/solid/contact_stream.h"

#include <algorithm>
#include <exception>
#include <functional>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"

namespace bodkin::fem {

namespace {

constexpr double least_ahead = 10.0;  // mm that a turned needle may always advance
constexpr std::string_view no_points =
    "contact points of the needle's line could not be computed, so that it continues with those that are there";
constexpr std::string_view no_coupling =
    "the needle's contact points could not be coupled with the nodes that the probe holds now, and stay as they were";
constexpr std::string_view no_memory =
    "the memory is exhausted; close other programs, or mesh the patient more coarsely";

void append_known(const anatomy::CondensedBody& body, const std::function<bool(const ContactPoint&)>& next) {
  std::vector<Mat3> between;
  for (std::size_t j = 0; j < body.nodes.size(); ++j) {
    between.resize(j + 1);
    const auto column = static_cast<Eigen::Index>(3 * j);
    for (std::size_t i = 0; i <= j; ++i)
      between[i] = body.compliance.block<3, 3>(static_cast<Eigen::Index>(3 * i), column);
    if (!next({body.nodes[j], body.tissues[j], body.in_mesh[j], between})) return;
  }
}

}  // namespace

ContactStream::ContactStream(std::shared_ptr<const ContactBody> body, std::shared_ptr<const anatomy::Case> patient,
                             const ContactStreamSettings& settings, std::shared_ptr<ContactLine> line)
    : body_(std::move(body)),
      patient_(std::move(patient)),
      settings_(settings),
      line_(std::move(line)),
      thread_([this] { serve(); }) {}

ContactStream::~ContactStream() {
  line_->close();
  thread_.join();
}

void ContactStream::serve() {
  while (const std::optional<ContactLine::Line> line = line_->next_line()) {
    if (line->is_coupling) {
      couple(*line);
      continue;
    }
    attempt(no_points, [&] { compute(*line); });
    line_->complete(*line);
  }
}

// False when it failed: the tick's thread is not notified; the person is told the `failed` message and the reason.
template <typename Work>
bool ContactStream::attempt(std::string_view failed, const Work& work) noexcept {
  try {
    work();
    return true;
  } catch (const std::bad_alloc&) {
    add_failure(failed, no_memory);
  } catch (const std::exception& error) {
    add_failure(failed, error.what());
  }
  return false;
}

void ContactStream::add_failure(std::string_view sentence, std::string_view why) noexcept {
  try {
    std::string text = fmt::format("{}: {}", sentence, why);
    const std::scoped_lock guard(lock_);
    if (std::find(reported_.begin(), reported_.end(), text) != reported_.end()) return;
    reported_.push_back(text);
    failures_.push_back(std::move(text));
  } catch (const std::bad_alloc&) {
    const std::scoped_lock guard(lock_);
    failed_without_words_ = reported_.empty();
  }
}

std::vector<std::string> ContactStream::take_failures() {
  const std::scoped_lock guard(lock_);
  if (std::exchange(failed_without_words_, false)) {
    reported_.push_back(fmt::format("{}: {}", no_points, no_memory));
    failures_.push_back(reported_.back());
  }
  return std::exchange(failures_, {});
}

void ContactStream::throw_failure() {
  if (const std::vector<std::string> failures = take_failures(); !failures.empty())
    throw SystemError(failures.front());
}

// The existing points, with other nodes held.
void ContactStream::couple(const ContactLine::Line& line) {
  bool done = points_ && points_->size() >= line.kept;
  const bool succeeded = attempt(no_coupling, [&] {
    if (done) {
      const std::span<const std::uint32_t> held(line.held.data(), line.held_count);
      *bound_ = body_->bind(settings_.left, held);
      held_.assign(held.begin(), held.end());
      points_->keep_first(line.kept);
      points_->bind_again();
    }
    for (std::size_t i = 0; done && i < line.kept; ++i) done = line_->put(line, i, points_->point(i));
  });
  line_->end_coupling(line, done && succeeded);
}

// Keeps the points that the needle has reached, and finds those ahead.
void ContactStream::find_points(const ContactLine::Line& line) {
  if (line.kept > 0) {
    points_->keep_first(line.kept);
    const double left = settings_.length - (line.entry - begin_).norm();
    points_->add(contact_sites_ahead(line.entry, line.direction, std::max(left, least_ahead), settings_.spacing,
                                     points_->tissue(line.kept - 1), *patient_),
                 line.direction);
    return;
  }
  points_.reset();
  const std::span<const std::uint32_t> held(line.held.data(), line.held_count);
  if (!bound_ || !std::equal(held.begin(), held.end(), held_.begin(), held_.end())) {
    bound_ = body_->bind(settings_.left, held);
    held_.assign(held.begin(), held.end());
  }
  begin_ = line.entry;
  const anatomy::NeedlePath path{line.entry, line.entry + settings_.length * line.direction};
  points_.emplace(*body_, settings_.tip_radius, *bound_);
  points_->add(contact_sites_along(line.is_planned ? patient_->prepared.path : path, settings_.length,
                                   settings_.spacing, *patient_),
               line.direction);
}

void ContactStream::compute(const ContactLine::Line& line) {
  if (line.kept > 0 && (!points_ || points_->size() < line.kept)) return;
  find_points(line);
  const auto append = [&](const ContactPoint& point) { return line_->append(line, point); };
  if (line.is_planned && line.kept == 0)
    append_known(*patient_->prepared.body, append);
  else
    points_->stream(line.kept, append);
}

}  // namespace bodkin::fem
