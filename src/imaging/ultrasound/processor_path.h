#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace bodkin::imaging {

// The inner loops are compiled several times from one source; all give the same bits.
enum class ProcessorPath : std::uint8_t { scalar, sse2, avx2, avx512 };

// "scalar", "SSE2", "AVX2", "AVX-512"; "vectors" for `sse2` on processors other than x86-64.
std::string_view name_of(ProcessorPath path);
// The paths that this processor can run, slowest first.
std::span<const ProcessorPath> processor_paths();
ProcessorPath best_processor_path();

}  // namespace bodkin::imaging
