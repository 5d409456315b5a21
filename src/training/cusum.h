#pragma once

#include <span>
#include <vector>

namespace bodkin::training {

// Parameters of the test for a learning curve.
struct CusumSettings {
  double acceptable = 0.10;    // failure rate of a person who masters the procedure; 0 to 1
  double unacceptable = 0.30;  // failure rate of a person who does not; above `acceptable`, below 1
  double alpha = 0.10;         // probability of rejecting a person who masters it; 0 to 0.5
  double beta = 0.10;          // probability of accepting a person who does not; 0 to 0.5
};

// Cumulative sum of successes and failures (sequential probability ratio test, Wald 1945; in anaesthesia Kestin
// 1995):
//
//   S_n = S_(n-1) + (failure ? 1 - s : -s)
//   P = ln(p1/p0), Q = ln((1 - p0)/(1 - p1)), s = Q/(P + Q)
//   h0 = ln((1 - alpha)/beta)/(P + Q), h1 = ln((1 - beta)/alpha)/(P + Q)
//
// p0 acceptable, p1 unacceptable. A fall by h0 below the last level shows mastery, a rise by h1 above it its absence;
// the test then restarts from there.
class Cusum {
 public:
  // Throws InputError for settings out of their ranges.
  explicit Cusum(const CusumSettings& settings);

  double step() const noexcept { return s_; }  // s, subtracted by a success
  double lower() const noexcept { return h0_; }
  double upper() const noexcept { return h1_; }

  struct Point {
    double value = 0.0;    // S_n
    bool mastery = false;  // the lower limit was crossed at this attempt
    bool failing = false;  // the upper limit was crossed at this attempt
  };
  // One point for each attempt; `failed` in chronological order.
  std::vector<Point> curve(std::span<const char> failed) const;

 private:
  double s_, h0_, h1_;
};

}  // namespace bodkin::training
