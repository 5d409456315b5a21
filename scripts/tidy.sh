#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER: runs clang-tidy over the source files of src/ as the compiler of BUILD_FOLDER sees them.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
git ls-files 'src/*.cpp' | xargs -P "$(nproc)" -n 1 clang-tidy -p "$1" --quiet 2>&1 |
  { grep -v -E '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -header-filter|warnings generated' || true; }
