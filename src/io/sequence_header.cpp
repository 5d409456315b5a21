#include "io/sequence_header.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parameter_value.h"

namespace bodkin::io {

namespace {

constexpr std::size_t longest_sequence_header = std::size_t{16} << 20U;  // bytes
constexpr double least_pixel = 1e-4, largest_pixel = 100.0;              // mm

// The lengths of the first two columns of a matrix of 16 numbers, row by row.
std::optional<std::array<double, 2>> steps_of(std::string_view text) {
  std::array<double, 16> numbers{};
  for (double& number : numbers) {
    text = without_blanks(text);
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failed != std::errc() || !std::isfinite(number)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
  const std::array<double, 2> steps = {std::hypot(numbers[0], numbers[4], numbers[8]),
                                       std::hypot(numbers[1], numbers[5], numbers[9])};
  for (const double step : steps) {
    if (!(step >= least_pixel && step <= largest_pixel)) return std::nullopt;
  }
  return steps;
}

}  // namespace

SequenceHeader parse_sequence_header(std::string_view bytes, std::size_t frame) {
  const std::string own = fmt::format("Seq_Frame{:04}_", frame);
  SequenceHeader header;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) continue;
    std::string_view key = without_blanks(line.substr(0, equals));
    const std::string_view value = without_blanks(line.substr(equals + 1));
    if (key == "ElementDataFile") break;
    if (key == "UltrasoundImageOrientation" && value.size() <= 3) header.orientation = value;
    if (key.starts_with(own)) key.remove_prefix(own.size());
    if (!key.starts_with("ImageTo") || !key.ends_with("Transform")) continue;
    if (const auto steps = steps_of(value)) {
      header.across = (*steps)[0];
      header.down = (*steps)[1];
    }
  }
  return header;
}

SequenceHeader read_sequence_header(const std::filesystem::path& file, std::size_t frame) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(fmt::format("{}: cannot be opened; expected a file that can be read", file.string()));
  std::string bytes(longest_sequence_header, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return parse_sequence_header(bytes, frame);
}

}  // namespace bodkin::io
