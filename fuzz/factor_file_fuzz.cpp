// Untrusted stored factors: any bytes are either refused with a sentence, or give a usable factor.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/scratch_file.h"

#include "core/error.h"
#include "core/files.h"
#include "fem/solid/factor_cache.h"

namespace {

// The contents behind the checksums, which random bytes do not pass: the counts of nodes and supernodes, the order,
// the sizes and the rows, a byte each.
void use_layout(std::span<const std::uint8_t> bytes, const std::string& scratch) {
  if (bytes.size() < 2) return;
  const std::size_t nodes = bytes[0] % 64, supernodes = bytes[1] % 64;
  bytes = bytes.subspan(2);
  if (bytes.size() < nodes + 2 * supernodes) return;
  std::vector<std::uint32_t> position(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(nodes));
  bytes = bytes.subspan(nodes);
  std::vector<bodkin::fem::FactorLayout::Size> sizes;
  for (std::size_t i = 0; i < supernodes; ++i) sizes.push_back({bytes[2 * i], bytes[2 * i + 1]});
  bytes = bytes.subspan(2 * supernodes);
  bodkin::fem::FactorLayout layout(std::move(position), sizes, {bytes.begin(), bytes.end()});
  const std::string numbers(sizeof(double) * layout.numbers, '\0');
  bodkin::write_file(scratch, numbers);
  const bodkin::fem::PackedFactor factor(std::move(layout), bodkin::MappedFile(scratch), 0);
  std::vector<bodkin::fem::CarriedPoint> points;
  std::vector<std::uint32_t> all;
  for (std::uint32_t node = 0; node < factor.nodes(); ++node) {
    points.push_back({{{node, 1.0}}});
    all.push_back(node);
  }
  if (!points.empty()) factor.displacements(factor.respond(points), all);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScratchFile scratch("factor");
  try {
    use_layout({data, size}, scratch.path());
  } catch (const bodkin::InputError&) {
  }
  bodkin::write_file(scratch.path(), {reinterpret_cast<const char*>(data), size});
  try {
    bodkin::fem::load_factor(scratch.path(), {});
  } catch (const bodkin::InputError&) {
  }
  return 0;
}
