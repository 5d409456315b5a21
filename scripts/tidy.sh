#!/usr/bin/env bash
# Runs clang-tidy over the source files of src/. Precompiled headers are left out: they are the compiler's own. So are the
# few files that include ITK: Debian's ITK headers refuse every compiler but g++.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
cmake --preset release -B build/tidy -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DBODKIN_TESTS=OFF -DBODKIN_BENCHMARKS=OFF \
  >/dev/null
git ls-files 'src/*.cpp' | xargs grep -L '#include <itk' | xargs -P "$(nproc)" -n 1 clang-tidy -p build/tidy --quiet 2>&1 |
  { grep -v -E '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -header-filter|warnings generated' || true; }
