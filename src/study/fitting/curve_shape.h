#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "study/fitting/fit_model.h"
#include "study/fitting/measured_curve.h"

namespace bodkin::study {

// mm, the depth at which the force begins to rise out of its noise.
double contact_of(const MeasuredCurve& curve);

// Samples at which the force falls during insertion, the steepest falls first: the tissue may have been punctured
// between such a sample and the one before. At most `most`.
std::vector<std::size_t> falls_of(const MeasuredCurve& curve, std::size_t most);

// N, standard deviation of the force from one sample to the next.
double noise_of(const MeasuredCurve& curve);

// The shape of the curve if the tissue is punctured before sample `yield`; 0: not punctured.
CurveShape shape_of(const MeasuredCurve& curve, double contact, std::size_t yield);

}  // namespace bodkin::study
