#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace bodkin::imaging {

// The inner loops are compiled several times from one source; all give the same bits.
enum class ProcessorPath : std::uint8_t { scalar, sse2, avx2, avx512 };

// "scalar", "SSE2", "AVX2", "AVX-512"; on other processors than x86-64 `sse2` is their own "vectors".
std::string_view name_of(ProcessorPath path);
// Those that this processor can run, slowest first.
std::span<const ProcessorPath> processor_paths();
ProcessorPath best_processor_path();

}  // namespace bodkin::imaging
