#pragma once

#include <vector>

namespace bodkin::imaging {

// One of the rays by which a slice gets its thickness: `off` standard deviations of the beam's elevation width from
// the middle, and its share of the sum.
struct SliceRay {
  double off = 0.0;
  double weight = 1.0;
};

// 1, 3, 5 or 7 rays, the middle one first. They stand for a Gaussian: equally far apart, weighted by it, and placed
// so that the variance of the whole is exactly that of the beam. Weights add up to 1.
std::vector<SliceRay> slice_rays(int count);

// A ray parallel to the scanlines, marched for all of them at once.
struct SlicePass {
  double off = 0.0;  // standard deviations of the beam's elevation width from the middle
  double weight = 1.0;
  bool alternates = false;  // on this side of even lines, on the other of odd ones
};

// How the rays of a slice are marched. Where a beam that is wider than the lines are apart is laid over the picture
// (`blended`), the two rays of a pair take turns from line to line, each with the weight of both: half the work, and
// the same in sum. Scatterers are heard on both sides of every line nevertheless, so that speckle does not depend on
// which line is where. Otherwise every ray has its own pass.
std::vector<SlicePass> slice_passes(const std::vector<SliceRay>& rays, bool blended);

// What is left of the variance of a noise of cells when samples of it, `apart` cells from one to the next, are added
// with `weights`. Samples in the same cell are equal, those further apart than a cell have nothing in common.
double variance_left(const std::vector<double>& weights, double apart);

// Weights of a Gaussian of standard deviation `deviation`, in steps, from the middle to `half` steps away; both sides
// together add up to 1.
std::vector<double> half_gaussian(double deviation, int half);

}  // namespace bodkin::imaging
