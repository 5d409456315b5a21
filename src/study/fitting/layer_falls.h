#pragma once

#include <cstddef>
#include <vector>

namespace bodkin::study {

// A sudden fall of a measured force, and the number of layers of the stack, from the skin, that the needle has met
// before it.
struct LayerFall {
  std::size_t sample = 0;
  std::size_t layers = 0;
};

// Assignments of layers to falls: each result has for every one of `layers` its sample, 0 for a layer that is not
// punctured. A fall belongs to a layer that the needle has met. `falls` are given by size: the largest that can all
// be explained at once are, in the order of the layers first, then with two neighbouring layers exchanged; if they
// are fewer than the layers, each choice of layers follows. At most `most` results, at least one.
std::vector<std::vector<std::size_t>> shares_of_falls(const std::vector<LayerFall>& falls, std::size_t layers,
                                                      std::size_t most);

}  // namespace bodkin::study
