#!/usr/bin/env bash
# tidy.sh BUILD_FOLDER...: runs clang-tidy over the source files of src/ with the compiler options of the first folder
# that builds them: a whole module at once, because most of the time goes into headers.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
git ls-files 'src/*.cpp' | sort > "$work/left"
for build in "$@"; do
  # Units with a source file that no earlier folder has; the longest first, because they take longest.
  for unit in $(wc -l "$build"/src/*/CMakeFiles/*.dir/Unity/unity_*_cxx.cxx | sort -rn | awk '$2 != "total" {print $2}'); do
    sed -n -E "s|^#include \"$root/(src/.*\.cpp)\"|\1|p" "$unit" | sort > "$work/of_unit"
    comm -12 "$work/left" "$work/of_unit" | grep -q . || continue
    comm -23 "$work/left" "$work/of_unit" > "$work/rest" && mv "$work/rest" "$work/left"
    echo "$build $unit" >> "$work/units"
  done
done
# Files compiled separately go first: the mesher's only file, which includes CGAL, takes longer than any module.
while read -r file; do
  of="$1"
  for build in "$@"; do
    grep -q "\"$root/$file\"" "$build/compile_commands.json" && of="$build" && break
  done
  echo "$of $file"
done < "$work/left" > "$work/alone"
cat "$work/alone" "$work/units" |
  xargs -P "$(nproc)" -L 1 clang-tidy --quiet --extra-arg=-Wno-unknown-warning-option -p 2>&1 |
  { grep -v -E '^[0-9]+ warnings? (generated|treated)|^Suppressed|^Use -header-filter|warnings generated' || true; }
