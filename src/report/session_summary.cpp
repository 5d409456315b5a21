#include "report/session_summary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "core/error.h"
#include "haptics/force_governor.h"

namespace bodkin::report {

namespace {

constexpr double degrees = 180.0 / EIGEN_PI;
constexpr double travel_interval = 0.01;        // s between samples of the travelled length
constexpr double retreat_of_redirection = 5.0;  // mm
constexpr double turn_of_redirection = 3.0;     // deg
constexpr double rest_speed = 1.0;              // mm/s
constexpr double rest_span = 0.1;               // s over which that speed is taken
constexpr double rest_length = 0.5;             // s
constexpr double outside_before_reentry = 1.0;  // mm travelled outside a critical structure before it counts again
constexpr std::size_t samples_to_enter = 2;
constexpr double on_target = 0.05;            // mm
constexpr double limit_worth_telling = 0.05;  // s
constexpr std::array<std::uint8_t, 5> limit_flags = {haptics::force_limit::peak, haptics::force_limit::thermal,
                                                     haptics::force_limit::passivity, haptics::force_limit::slew,
                                                     haptics::force_limit::fault};

Vec3 tip_of(const simulation::TickRecord& record) {
  return record.input.needle.translation();
}

double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * degrees;
}

double distance_to_segment(const Vec3& point, const anatomy::NeedlePath& path) {
  const Vec3 along = path.target - path.entry;
  const double square = along.squaredNorm();
  const double share = square > 0.0 ? std::clamp((point - path.entry).dot(along) / square, 0.0, 1.0) : 0.0;
  return (path.entry + share * along - point).norm();
}

TargetError error_of(const Vec3& tip, const anatomy::NeedlePath& path) {
  const Vec3 miss = tip - path.target;
  TargetError error;
  error.distance = miss.norm();
  error.axial = path.length() > 0.0 ? miss.dot(path.direction()) : 0.0;
  error.lateral = std::sqrt(std::max(0.0, miss.squaredNorm() - error.axial * error.axial));
  return error;
}

// Counts redirections inside one insertion.
int redirections_in(std::span<const simulation::TickRecord> ticks) {
  int count = 0;
  double deepest = 0.0, shallowest = 0.0;
  Vec3 axis_at_deepest = Vec3::UnitZ();
  bool retreated = false;
  for (const simulation::TickRecord& record : ticks) {
    const double depth = record.output.depth;
    const Vec3 axis = needle_axis(record.input.needle);
    if (!retreated) {
      if (depth >= deepest) {
        deepest = depth;
        axis_at_deepest = axis;
      } else if (deepest - depth > retreat_of_redirection) {
        retreated = true;
        shallowest = depth;
      }
      continue;
    }
    shallowest = std::min(shallowest, depth);
    if (depth - shallowest < 1.0) continue;  // not yet an advance
    if (angle_between(axis, axis_at_deepest) > turn_of_redirection) ++count;
    retreated = false;
    deepest = depth;
    axis_at_deepest = axis;
  }
  return count;
}

class Summariser {
 public:
  Summariser(const session::Session& session, const anatomy::Case& patient)
      : ticks_(session.ticks),
        session_(session),
        patient_(patient),
        dt_(session.header.dt),
        path_(session.header.path) {}

  SessionSummary summarise() {
    const std::vector<Insertion> all = insertions(ticks_);
    summary_.duration = static_cast<double>(ticks_.back().tick - ticks_.front().tick) * dt_;
    summary_.insertions = static_cast<int>(all.size());
    walk();
    for (const Insertion& insertion : all) {
      const auto part = ticks_.subspan(insertion.first, insertion.last - insertion.first + 1);
      summary_.redirections += redirections_in(part);
      if (insertion.deepest >= summary_.deepest) summary_.crossings = tissues_crossed(part, dt_);
      summary_.deepest = std::max(summary_.deepest, insertion.deepest);
    }
    if (!all.empty()) {
      const Vec3 planned = path_.target - path_.entry;
      summary_.angle_at_contact = angle_between(needle_axis(ticks_[all.front().first].input.needle), planned);
      summary_.angle_at_end = angle_between(needle_axis(ticks_[all.back().last].input.needle), planned);
    }
    finish_tip();
    critical();
    for (const session::SessionEvent& event : session_.events) {
      summary_.bone_contacts += event.event.kind == forces::EventKind::bone_contact ? 1 : 0;
      summary_.losses_of_resistance += event.event.kind == forces::EventKind::loss_of_resistance ? 1 : 0;
    }
    return std::move(summary_);
  }

 private:
  double time_of(const simulation::TickRecord& record) const {
    return static_cast<double>(record.tick - ticks_.front().tick) * dt_;
  }

  // Everything that one pass over the ticks can find.
  void walk() {
    const anatomy::TissueProperties* aim = patient_.library.find(patient_.description.procedure.target_tissue);
    const double tolerance = patient_.description.procedure.target_tolerance;
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::round(travel_interval / dt_)));
    std::map<anatomy::TissueId, TissueTotal> totals;
    double squares = 0.0;
    std::size_t in_body = 0;
    std::optional<double> first_contact;
    summary_.closest_distance = std::numeric_limits<double>::infinity();
    bool limited_before = false;
    std::array<double, limit_flags.size()> limit_times{};
    for (std::size_t i = 0; i < ticks_.size(); ++i) {
      const simulation::TickRecord& record = ticks_[i];
      const simulation::TickOutput& output = record.output;
      const Vec3 tip = tip_of(record);
      // A tissue stiffer than the device renders steadily is a warning: the force is passed on as it was asked for.
      const bool limited = (output.limits & ~haptics::force_limit::stiffness) != 0;
      for (std::size_t n = 0; n < limit_flags.size(); ++n) {
        if ((output.limits & limit_flags[n]) != 0) limit_times[n] += dt_;
      }
      summary_.interventions += limited && !limited_before ? 1 : 0;
      summary_.limited_time += limited ? dt_ : 0.0;
      limited_before = limited;
      if (i > 0)
        summary_.work -=
            0.5 * (output.applied.force + ticks_[i - 1].output.applied.force).dot(tip - tip_of(ticks_[i - 1]));
      const double to_target = (tip - path_.target).norm();
      if (to_target < summary_.closest_distance) {
        summary_.closest_distance = to_target;
        summary_.closest_time = time_of(record);
      }
      if (!output.in_contact) continue;
      ++in_body;
      if (!first_contact) first_contact = time_of(record);
      if (!summary_.time_to_target && to_target < tolerance)
        summary_.time_to_target = time_of(record) - *first_contact;
      if (!summary_.target_tissue_time && aim != nullptr && output.tissue == aim->id) {
        summary_.target_tissue_time = time_of(record);
      }
      if (i >= stride && i % stride == 0 && ticks_[i - stride].output.in_contact) {
        summary_.path_length += (tip - tip_of(ticks_[i - stride])).norm();
      }
      const double deviation = distance_to_segment(tip, path_);
      squares += deviation * deviation;
      summary_.deviation_max = std::max(summary_.deviation_max, deviation);
      if (output.resistance > summary_.peak_force) {
        summary_.peak_force = output.resistance;
        summary_.peak_depth = output.depth;
        summary_.peak_tissue = output.tissue;
      }
      if (output.tissue == anatomy::tissue::air) continue;
      const auto [place, fresh] = totals.try_emplace(output.tissue);
      TissueTotal& total = place->second;
      if (fresh) total = {output.tissue, output.depth, output.depth, 0.0, 0.0, output.depth};
      total.from = std::min(total.from, output.depth);
      total.to = std::max(total.to, output.depth);
      total.time += dt_;
      if (output.resistance > total.peak_force) {
        total.peak_force = output.resistance;
        total.peak_depth = output.depth;
      }
    }
    for (std::size_t n = 0; n < limit_flags.size(); ++n) {
      if (limit_times[n] > 0.0) summary_.limits.push_back({limit_flags[n], limit_times[n]});
    }
    summary_.time_in_body = static_cast<double>(in_body) * dt_;
    summary_.deviation_rms = in_body > 0 ? std::sqrt(squares / static_cast<double>(in_body)) : 0.0;
    for (const auto& [id, total] : totals) summary_.tissues.push_back(total);
    std::stable_sort(summary_.tissues.begin(), summary_.tissues.end(),
                     [](const TissueTotal& a, const TissueTotal& b) { return a.from < b.from; });
  }

  // The place that counts as the tip's last, see FinalTip.
  void finish_tip() {
    const auto window = static_cast<std::size_t>(std::max(1.0, std::round(rest_length / dt_)));
    const auto span = static_cast<std::size_t>(std::max(1.0, std::round(rest_span / dt_)));
    Vec3 sum = Vec3::Zero();
    std::size_t resting = 0;
    for (std::size_t i = ticks_.size(); i-- > 1;) {
      const Vec3 tip = tip_of(ticks_[i]);
      // The speed over a tenth of a second, so that neither tremor nor the resolution of a device is a motion.
      const std::size_t before = i >= span ? i - span : 0;
      const double speed = (tip - tip_of(ticks_[before])).norm() / (static_cast<double>(i - before) * dt_);
      if (!ticks_[i].output.in_contact || speed >= rest_speed) {
        sum.setZero();
        resting = 0;
        continue;
      }
      sum += tip;
      if (++resting == window) break;
    }
    if (ticks_.back().output.in_contact) {
      summary_.final_tip = tip_of(ticks_.back());
      summary_.final_tip_from = FinalTip::end_of_session;
    } else if (resting == window) {
      summary_.final_tip = sum / static_cast<double>(window);
      summary_.final_tip_from = FinalTip::last_rest;
    } else {
      const auto deepest = std::max_element(
          ticks_.begin(), ticks_.end(), [](const simulation::TickRecord& a, const simulation::TickRecord& b) {
            return (a.output.in_contact ? a.output.depth : -1.0) < (b.output.in_contact ? b.output.depth : -1.0);
          });
      summary_.final_tip = tip_of(*deepest);
    }
    summary_.final_error = error_of(summary_.final_tip, path_);
  }

  void critical() {
    if (patient_.structures.empty()) return;
    for (const anatomy::Structure& structure : patient_.description.structures) {
      if (!structure.critical) continue;
      CriticalEntry entry;
      entry.structure = structure.name;
      std::size_t inside = 0;
      double outside_travel = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < ticks_.size(); ++i) {
        const Vec3 tip = tip_of(ticks_[i]);
        if (anatomy::nearest<std::uint16_t>(patient_.structures, tip, 0) != structure.label) {
          inside = 0;
          if (i > 0) outside_travel += (tip - tip_of(ticks_[i - 1])).norm();
          continue;
        }
        entry.time_inside += dt_;
        if (++inside != samples_to_enter || outside_travel < outside_before_reentry) continue;
        outside_travel = 0.0;
        if (++entry.entries == 1) {
          entry.time = time_of(ticks_[i]);
          entry.depth = ticks_[i].output.depth;
        }
      }
      if (entry.entries > 0) summary_.critical.push_back(entry);
    }
  }

  std::span<const simulation::TickRecord> ticks_;
  const session::Session& session_;
  const anatomy::Case& patient_;
  double dt_;
  anatomy::NeedlePath path_;
  SessionSummary summary_;
};

std::string times(int count) {
  return count == 1 ? "once" : (count == 2 ? "twice" : fmt::format("{} times", count));
}

// What the governor did to the force under one limit, for the person who held the needle.
std::string limit_text(std::uint8_t limit, const anatomy::DeviceLimits& device) {
  switch (limit) {
    case haptics::force_limit::peak:
      return fmt::format("the device can push no more than {:g} N", device.peak_force);
    case haptics::force_limit::thermal:
      return fmt::format("its motors can hold no more than {:g} N for long", device.continuous_force);
    case haptics::force_limit::passivity:
      return "the tissue would have given back more energy than the hand had put in, and was damped";
    case haptics::force_limit::slew:
      return "the force grew faster than is let through";
    default:
      return "after a fault the force was taken to zero";
  }
}

}  // namespace

SessionSummary summarise(const session::Session& session, const anatomy::Case& patient) {
  if (session.ticks.empty()) throw InputError("the session holds no tick, so that there is nothing to report");
  return Summariser(session, patient).summarise();
}

Verdict judge(const SessionSummary& summary, const session::Session& session, const anatomy::Case& patient) {
  const anatomy::Procedure& procedure = patient.description.procedure;
  Verdict verdict;
  if (summary.insertions == 0) {
    verdict.headline = "The needle never touched the body";
    return verdict;
  }
  const anatomy::TissueProperties* aim = patient.library.find(procedure.target_tissue);
  verdict.reached = aim != nullptr ? summary.target_tissue_time.has_value() : summary.time_to_target.has_value();
  if (aim != nullptr) {
    verdict.headline = verdict.reached ? fmt::format("The tip reached the {}", aim->title)
                                       : fmt::format("The tip did not reach the {}", aim->title);
  } else {
    verdict.headline = verdict.reached ? "The tip reached the target" : "The tip did not reach the target";
  }
  const TargetError& error = summary.final_error;
  const char* ending = summary.final_tip_from == FinalTip::end_of_session ? "It ended"
                       : summary.final_tip_from == FinalTip::last_rest    ? "It came to rest"
                                                                          : "Its deepest point lies";
  verdict.remarks.push_back(
      error.distance < on_target
          ? fmt::format("{} on the planned target.", ending)
          : fmt::format("{} {:.1f} mm from the planned target: {:.1f} mm {} and {:.1f} mm to the side.", ending,
                        error.distance, std::abs(error.axial), error.axial >= 0.0 ? "too deep" : "short of it",
                        error.lateral));
  if (summary.losses_of_resistance > 0) {
    verdict.remarks.push_back(
        fmt::format("The loss of resistance could be felt {}.", times(summary.losses_of_resistance)));
  }
  if (summary.bone_contacts > 0) {
    verdict.remarks.push_back(fmt::format("The tip met bone {}.", times(summary.bone_contacts)));
  }
  for (const CriticalEntry& entry : summary.critical) {
    verdict.remarks.push_back(
        fmt::format("It entered {}, which it must not touch, at {:.1f} s.", entry.structure, entry.time));
  }
  if (summary.redirections > 0) {
    verdict.remarks.push_back(
        fmt::format("The needle was drawn back and redirected {}.", times(summary.redirections)));
  }
  if (summary.insertions > 1)
    verdict.remarks.push_back(fmt::format("The skin was met {}.", times(summary.insertions)));
  if (summary.limited_time > limit_worth_telling) {
    std::string reasons;
    for (const LimitTime& limit : summary.limits) {
      reasons += fmt::format("{}{} ({:.2f} s)", reasons.empty() ? "" : "; ",
                             limit_text(limit.limit, patient.description.device), limit.time);
    }
    verdict.remarks.push_back(
        fmt::format("The hand felt another force than the tissue asked for {}, {:.2f} s in all: {}.",
                    times(summary.interventions), summary.limited_time, reasons));
  }
  if (!session.finished) {
    verdict.remarks.emplace_back("The recording broke off before its end; this is what was saved.");
  }
  return verdict;
}

}  // namespace bodkin::report
