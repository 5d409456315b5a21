// Debian's ITK was configured for g++ alone and refuses other compilers, in one header, although clang compiles all
// of it. That header is shown g++ here, before anything else includes it.
#pragma push_macro("__clang__")
#pragma push_macro("__GNUC__")
#undef __clang__
#undef __GNUC__
#define __GNUC__ 12
#include <itk_compiler_detection.h>
#pragma pop_macro("__GNUC__")
#pragma pop_macro("__clang__")
