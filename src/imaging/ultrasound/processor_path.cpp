#include "imaging/ultrasound/processor_path.h"

#include <array>

#include "imaging/ultrasound/scan_kernel.h"

namespace bodkin::imaging {

namespace scan {

extern const Kernel kernel_scalar;
extern const Kernel kernel_sse2;
#ifdef __x86_64__
extern const Kernel kernel_avx2;
extern const Kernel kernel_avx512;
#endif

const Kernel& kernel(ProcessorPath path) {
  switch (path) {
    case ProcessorPath::scalar:
      return kernel_scalar;
#ifdef __x86_64__
    case ProcessorPath::avx2:
      return kernel_avx2;
    case ProcessorPath::avx512:
      return kernel_avx512;
#endif
    default:
      return kernel_sse2;
  }
}

}  // namespace scan

std::string_view name_of(ProcessorPath path) {
  switch (path) {
    case ProcessorPath::scalar:
      return "scalar";
    case ProcessorPath::avx2:
      return "AVX2";
    case ProcessorPath::avx512:
      return "AVX-512";
    default:
#ifdef __x86_64__
      return "SSE2";
#else
      return "vectors";
#endif
  }
}

std::span<const ProcessorPath> processor_paths() {
  static constexpr std::array all = {ProcessorPath::scalar, ProcessorPath::sse2, ProcessorPath::avx2,
                                     ProcessorPath::avx512};
  static const std::size_t count = [] {
#ifdef __x86_64__
    const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512cd");
    if (wide) return std::size_t{4};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2"))
      return std::size_t{3};
#endif
    return std::size_t{2};
  }();
  return std::span(all).first(count);
}

ProcessorPath best_processor_path() {
  return processor_paths().back();
}

}  // namespace bodkin::imaging
