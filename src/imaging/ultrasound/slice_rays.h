#pragma once

#include <vector>

namespace bodkin::imaging {

// One of the rays that represent the thickness of a slice: `off` standard deviations of the beam's elevation width
// from the middle, and its share of the sum.
struct SliceRay {
  double off = 0.0;
  double weight = 1.0;
};

// 1, 3, 5 or 7 rays, the middle one first. They represent a Gaussian: equally spaced, weighted by it, and placed so
// that the total variance is exactly that of the beam. Weights add up to 1.
std::vector<SliceRay> slice_rays(int count);

// A ray parallel to the scanlines, marched for all of them at once.
struct SlicePass {
  double off = 0.0;  // standard deviations of the beam's elevation width from the middle
  double weight = 1.0;
  bool alternates = false;  // on this side for even lines, on the other for odd ones
};

// The passes in which the rays of a slice are marched. If a beam wider than the distance of the lines is applied to
// the image (`blended`), the two rays of a pair alternate from line to line, and each gets the weight of the pair.
// This halves the work and keeps the sum. Scatterers are nevertheless included on both sides of every line, so that
// speckle does not depend on the numbering of the lines. Otherwise every ray has its own pass.
std::vector<SlicePass> slice_passes(const std::vector<SliceRay>& rays, bool blended);

// The remaining variance of a noise of cells when samples of it, at distances of `apart` cells, are added with
// `weights`. Samples in the same cell are equal, those farther apart than a cell are independent.
double variance_left(const std::vector<double>& weights, double apart);

// Weights of a Gaussian of standard deviation `deviation`, in steps, from the middle to `half` steps away; both sides
// together add up to 1.
std::vector<double> half_gaussian(double deviation, int half);

}  // namespace bodkin::imaging
