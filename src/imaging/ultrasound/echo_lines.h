#pragma once

#include <cstddef>
#include <span>

namespace bodkin::imaging {

// The echoes of an image before its beam is given a width: rows of `stride` floats, one row per sample.
struct EchoLines {
  int lines = 0, samples = 0, stride = 0;
  std::span<float> in_phase;         // samples x stride
  std::span<float> quadrature;       // samples x stride
  std::span<const float> amplitude;  // samples x stride: there and back, of the sound that reaches a sample

  std::size_t at(int sample, int line) const {
    return static_cast<std::size_t>(sample) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(line);
  }
  // Adds an echo between two samples of a line, divided between them. No effect outside the rows.
  void add(double sample, int line, double echo) const {
    if (!(sample >= 0.0) || sample >= samples - 1) return;
    const int before = static_cast<int>(sample);
    const double part = sample - before;
    in_phase[at(before, line)] += static_cast<float>((1.0 - part) * echo);
    in_phase[at(before + 1, line)] += static_cast<float>(part * echo);
  }
};

}  // namespace bodkin::imaging
