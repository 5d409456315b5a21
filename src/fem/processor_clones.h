#pragma once

// A function with this in front is compiled twice, for every x86-64 and for those with AVX2 (not with its fused
// multiply-add: -ffp-contract=off), and the processor's own is taken when the program starts. Other compilers and
// processors get the plain one.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && defined(__linux__)
#define BODKIN_PROCESSOR_CLONES __attribute__((target_clones("default", "avx2")))
#else
#define BODKIN_PROCESSOR_CLONES
#endif
