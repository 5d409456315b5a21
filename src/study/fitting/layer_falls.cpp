#include "study/fitting/layer_falls.h"

#include <algorithm>
#include <utility>

namespace bodkin::study {

namespace {

// Whether each fall can have its own layer: sorted by the layers met, the k-th has met at least k.
bool have_layers(std::vector<LayerFall> falls, std::size_t layers) {
  std::sort(falls.begin(), falls.end(), [](const auto& a, const auto& b) { return a.layers < b.layers; });
  for (std::size_t i = 0; i < falls.size(); ++i)
    if (std::min(falls[i].layers, layers) <= i) return false;
  return true;
}

// The next choice of as many of `layers` layers, ascending; false after the last one.
bool next_choice(std::vector<std::size_t>& chosen, std::size_t layers) {
  for (std::size_t i = chosen.size(); i-- > 0;) {
    if (chosen[i] + (chosen.size() - i) >= layers) continue;
    ++chosen[i];
    for (std::size_t k = i + 1; k < chosen.size(); ++k) chosen[k] = chosen[k - 1] + 1;
    return true;
  }
  return false;
}

}  // namespace

std::vector<std::vector<std::size_t>> shares_of_falls(const std::vector<LayerFall>& falls, std::size_t layers,
                                                      std::size_t most) {
  std::vector<LayerFall> explained;
  for (const LayerFall& fall : falls) {
    if (explained.size() == layers) break;
    explained.push_back(fall);
    if (!have_layers(explained, layers)) explained.pop_back();
  }
  std::sort(explained.begin(), explained.end(), [](const auto& a, const auto& b) { return a.sample < b.sample; });

  std::vector<std::vector<std::size_t>> shares;
  std::vector<std::size_t> chosen(explained.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = i;
  const auto share = [&](const std::vector<LayerFall>& order) {
    std::vector<std::size_t> samples(layers, 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (order[i].layers <= chosen[i]) return;
      samples[chosen[i]] = order[i].sample;
    }
    if (shares.size() < most) shares.push_back(std::move(samples));
  };
  do {
    share(explained);
    for (std::size_t i = 1; i < explained.size(); ++i) {
      std::vector<LayerFall> exchanged = explained;
      std::swap(exchanged[i - 1], exchanged[i]);
      share(exchanged);
    }
  } while (shares.size() < most && next_choice(chosen, layers));
  if (shares.empty()) shares.emplace_back(layers, 0);
  return shares;
}

}  // namespace bodkin::study
