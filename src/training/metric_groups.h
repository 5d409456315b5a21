#pragma once

#include <vector>

#include "training/metric.h"

namespace bodkin::training {

// The parts of all_metrics().
std::vector<Metric> metrics_of_time();
std::vector<Metric> metrics_of_motion();
std::vector<Metric> metrics_of_target();
std::vector<Metric> metrics_of_path();
std::vector<Metric> metrics_of_tissue();
std::vector<Metric> metrics_of_hands();
std::vector<Metric> metrics_of_technique();
std::vector<Metric> metrics_of_ultrasound();
std::vector<Metric> metrics_of_guidance();
std::vector<Metric> metrics_of_palpation();
std::vector<Metric> metrics_of_fluid();

// LPS mm, positions palpated by a finger before the first insertion, in order.
std::vector<Vec3> felt_before_entry(const Attempt& attempt);

// The value of an attempt that has an insertion, or nothing.
template <typename Compute>
std::optional<double> with_insertion(const Measured& measured, const Compute& compute) {
  if (measured.attempt.insertions.empty()) return std::nullopt;
  return static_cast<double>(compute(measured.attempt));
}

}  // namespace bodkin::training
