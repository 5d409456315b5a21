#include <algorithm>

#include "training/metric_groups.h"

namespace bodkin::training {

namespace {

double count_of(const Measured& measured, forces::EventKind kind) {
  const auto& events = measured.attempt.session().events;
  return static_cast<double>(std::count_if(
      events.begin(), events.end(), [kind](const session::SessionEvent& each) { return each.event.kind == kind; }));
}

std::optional<double> punctures(const Measured& measured) {
  return count_of(measured, forces::EventKind::puncture);
}

std::optional<double> bone_contacts(const Measured& measured) {
  return count_of(measured, forces::EventKind::bone_contact);
}

std::optional<double> bone_force(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  double most = 0.0;
  bool any = false;
  std::size_t from = 0;
  bool on_bone = false;
  const auto take = [&](std::size_t to) {
    for (std::size_t i = from; i <= to; ++i) most = std::max(most, attempt.resistance[i]);
  };
  for (const session::SessionEvent& each : attempt.session().events) {
    if (each.event.kind == forces::EventKind::bone_contact && !on_bone) {
      from = attempt.index_of(each);
      on_bone = any = true;
    } else if (each.event.kind == forces::EventKind::bone_left && on_bone) {
      take(attempt.index_of(each));
      on_bone = false;
    }
  }
  if (on_bone) take(attempt.size() - 1);
  return any ? std::optional(most) : std::nullopt;
}

std::optional<double> of_loss(const Measured& measured, double Puncture::*member) {
  const Puncture* loss = measured.loss();
  return loss == nullptr ? std::nullopt : std::optional(loss->*member);
}

std::optional<double> loss_depth(const Measured& measured) {
  return of_loss(measured, &Puncture::depth);
}
std::optional<double> loss_overshoot(const Measured& measured) {
  return of_loss(measured, &Puncture::overshoot);
}
std::optional<double> loss_speed(const Measured& measured) {
  return of_loss(measured, &Puncture::speed);
}
std::optional<double> loss_approach(const Measured& measured) {
  return of_loss(measured, &Puncture::approach);
}
std::optional<double> loss_reaction(const Measured& measured) {
  return of_loss(measured, &Puncture::reaction);
}

std::optional<double> loss_force(const Measured& measured) {
  const Attempt& attempt = measured.attempt;
  for (const session::SessionEvent& each : attempt.session().events) {
    if (each.event.kind == forces::EventKind::loss_of_resistance) return each.event.value;
  }
  return std::nullopt;
}

std::optional<double> overshoot_max(const Measured& measured) {
  double most = 0.0;
  for (const Puncture& puncture : measured.punctures) most = std::max(most, puncture.overshoot);
  return measured.punctures.empty() ? std::nullopt : std::optional(most);
}

std::optional<double> peak_force(const Measured& measured) {
  return with_insertion(measured, [&](const Attempt&) { return measured.peak_force; });
}

std::optional<double> mean_force(const Measured& measured) {
  return with_insertion(measured, [](const Attempt& attempt) {
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < attempt.size(); ++i) {
      if (attempt.inside[i] == 0) continue;
      sum += attempt.resistance[i];
      count += 1.0;
    }
    return sum / count;
  });
}

std::optional<double> work(const Measured& measured) {
  return measured.work;
}

}  // namespace

std::vector<Metric> metrics_of_tissue() {
  return {
      {"punctures", "", "tissues that gave way", "events `puncture`", "PerkTutor, Tissue Punctures", punctures},
      {"loss_depth_mm", "mm", "depth at the loss of resistance", "of the first loss of resistance, or of pressure",
       "Bodkin", loss_depth},
      {"loss_force_N", "N", "fall of the force at the loss of resistance", "value of the first such event", "Bodkin",
       loss_force},
      {"loss_overshoot_mm", "mm", "overshoot after the loss of resistance",
       "travel inwards until the tip is slower than 1 mm/s", "Bodkin", loss_overshoot},
      {"loss_approach_mm_per_s", "mm/s", "speed before the loss of resistance",
       "greatest speed inwards in the second before it, over 100 ms", "Bodkin", loss_approach},
      {"loss_speed_mm_per_s", "mm/s", "speed after the loss of resistance",
       "greatest speed inwards until then, over 20 ms", "Bodkin", loss_speed},
      {"loss_reaction_s", "s", "reaction to the loss of resistance", "time until then", "Bodkin", loss_reaction},
      {"overshoot_max_mm", "mm", "greatest overshoot after a puncture", "the same travel after any tissue gave way",
       "Bodkin", overshoot_max},
      {"bone_contacts", "", "contacts with bone", "events `bone_contact`", "Sutherland et al. 2013", bone_contacts},
      {"bone_force_N", "N", "greatest force on bone", "largest resistance while the tip was on bone", "Bodkin",
       bone_force},
      {"peak_force_N", "N", "largest resistance", "over all ticks in the body", "Bodkin", peak_force},
      {"mean_force_N", "N", "mean resistance", "the same, mean", "Bodkin", mean_force},
      {"work_N_mm", "N mm", "work done by the hand", "sum of -F . dp, F the force applied to the hand", "Bodkin",
       work}};
}

}  // namespace bodkin::training
