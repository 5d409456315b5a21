#pragma once

#include <cstdint>

#include "patient/synthetic/lumbar.h"

namespace bodkin::patient {

struct LumbarVariant {
  LumbarParameters parameters;  // with the seed; the spacing is the default
  int gauge = 22;               // of the needle: 20, 22 or 25
};

// A lumbar patient with parameters drawn from the seed, each from a sequence of its own: age uniform from 20 to 90
// years; height about 1.70 m, standard deviation 0.09; body mass index mostly 19 to 35, some up to 45; flexion 0.3 to
// 1; in every fourth a scoliosis of 10 to 35 degrees to either side; from 50 years on, increasingly often with age,
// ligaments calcified by 0.2 to 0.8. The distributions are our choice.
LumbarVariant draw_variant(std::uint64_t seed);

}  // namespace bodkin::patient
