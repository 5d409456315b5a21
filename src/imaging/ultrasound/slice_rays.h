#pragma once

#include <vector>

namespace bodkin {

// One of the rays by which a slice gets its thickness: `off` standard deviations of the beam's elevation width from
// the middle, and its share of the sum.
struct SliceRay {
  double off = 0.0;
  double weight = 1.0;
};

// 1, 3, 5 or 7 rays, the middle one first. They stand for a Gaussian: equally far apart, weighted by it, and placed
// so that the variance of the whole is exactly that of the beam. Weights add up to 1.
std::vector<SliceRay> slice_rays(int count);

// What is left of the variance of a noise of cells when samples of it, `apart` cells from one to the next, are added
// with `weights`. Samples in the same cell are equal, those further apart than a cell have nothing in common.
double variance_left(const std::vector<double>& weights, double apart);

// Weights of a Gaussian of standard deviation `deviation`, in steps, from the middle to `half` steps away; both sides
// together add up to 1.
std::vector<double> half_gaussian(double deviation, int half);

}  // namespace bodkin
