#include "imaging/ultrasound/reverberation.h"

#include <algorithm>
#include <cmath>

#include "imaging/ultrasound/scan_kernel.h"
#include "imaging/ultrasound/scatterers.h"

namespace bodkin::imaging {

namespace {

constexpr double weakest = 1e-5;      // amplitude; less is black on every screen
constexpr double haze = 0.02;         // of the surface's echo
constexpr double haze_length = 15.0;  // mm in which it falls to 1/e
constexpr double haze_from = 0.45;    // minimum echo of gas: bone reflects less

void add_haze(const EchoLines& rows, int line, int from, double echo, double spacing) noexcept {
  const auto& cells = scatterers().cells;
  const auto fade = static_cast<float>(std::exp(-spacing / haze_length));
  auto level = static_cast<float>(echo * haze / 64.0);
  auto cell = static_cast<std::size_t>(line) * 977 % cells.size();
  for (int k = from + 1; k < rows.samples; ++k, level *= fade) {
    const std::uint32_t scatterer = cells[cell];
    rows.in_phase[rows.at(k, line)] += level * static_cast<float>(static_cast<std::int8_t>(scatterer & 0xFFU));
    rows.quadrature[rows.at(k, line)] += level * static_cast<float>(static_cast<std::int8_t>(scatterer >> 8 & 0xFFU));
    cell = cell + 1 < cells.size() ? cell + 1 : 0;
  }
}

}  // namespace

void add_reverberation(const EchoLines& rows, std::span<const float> strong_at, std::span<const float> strong_echo,
                       double spacing) noexcept {
  for (int line = 0; line < rows.lines; ++line) {
    const auto at = static_cast<double>(strong_at[static_cast<std::size_t>(line)]);
    const auto first = static_cast<double>(strong_echo[static_cast<std::size_t>(line)]);
    if (at < 1.0 || first < weakest) continue;
    double echo = first;
    for (int n = 2; n * at < rows.samples && echo > weakest; ++n) {
      echo *= face_reflects * first;
      rows.add(n * at, line, echo);
    }
    if (first > haze_from) add_haze(rows, line, static_cast<int>(at), first, spacing);
  }
}

}  // namespace bodkin::imaging
