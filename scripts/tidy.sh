#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER: runs clang-tidy over the source files of src/ as the compiler of BUILD_FOLDER sees them: a whole
# module at once, for it is the headers that take the time.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
mapfile -t units < <(wc -l "$1"/src/*/CMakeFiles/*.dir/Unity/unity_*_cxx.cxx | sort -rn | awk '$2 != "total" {print $2}')
mapfile -t left_out < <(git ls-files 'src/*.cpp' | while read -r file; do
  grep -q -F "\"$root/$file\"" "${units[@]}" || echo "$file"
done)
# The longest first: the mesher's one file, which includes CGAL, takes longer than any module.
printf '%s\n' "${left_out[@]}" "${units[@]}" | sed '/^$/d' | xargs -P "$(nproc)" -n 1 clang-tidy -p "$1" --quiet 2>&1 |
  { grep -v -E '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -header-filter|warnings generated' || true; }
