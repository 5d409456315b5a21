#pragma once

#include <cstdlib>

#include <gtest/gtest.h>

// Whether the meshing worker was built with these tests.
#ifdef BODKIN_HAS_MESHER
inline constexpr bool mesher_built = true;
#else
inline constexpr bool mesher_built = false;
#endif

#define BODKIN_NEEDS_MESHER()                                                                                      \
  do {                                                                                                             \
    if (!mesher_built) GTEST_SKIP() << "bodkin-mesher is not built here (BODKIN_MESHER=OFF: sanitizers, no CGAL)"; \
    setenv("BODKIN_MESHER_WORKER", BODKIN_BUILD "/bin/bodkin-mesher", 1);                                          \
  } while (false)
