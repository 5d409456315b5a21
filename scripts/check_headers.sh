#!/usr/bin/env bash
# check_headers.sh: every header of src/ compiles by itself, which the other builds do not show: they compile a module at
# once, or start from precompiled headers. Most of the time would go into Eigen, so the headers that include it, by
# themselves or through others, start from one precompiled Eigen; the rest start from nothing.
set -euo pipefail
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
read -r -a window < <(pkg-config --cflags Qt5Widgets)
flags=(-std=c++20 -fPIC -Isrc -isystem /usr/include/eigen3 -isystem /usr/include/vtk-9.1
  "${window[@]}" -Wno-pragma-once-outside-header -w)

# The headers that reach Eigen, found by following the lines #include "module/file.h".
git ls-files 'src/*.h' > "$work/all"
xargs awk '
  { file = FILENAME; sub(/^src\//, "", file) }
  /^#include <Eigen\// { reaches[file] = 1 }
  /^#include "/ { split($0, part, "\""); from[++edges] = file; to[edges] = part[2] }
  END {
    do {
      grown = 0
      for (i = 1; i <= edges; ++i) if (reaches[to[i]] && !reaches[from[i]]) grown = reaches[from[i]] = 1
    } while (grown)
    for (file in reaches) if (reaches[file]) print "src/" file
  }' < "$work/all" | sort > "$work/with_eigen"

printf '#include <Eigen/Core>\n#include <Eigen/Geometry>\n' > "$work/eigen.h"
clang++ "${flags[@]}" -x c++-header "$work/eigen.h" -o "$work/eigen.pch"
sort "$work/all" | comm -23 - "$work/with_eigen" |
  xargs -r -P "$(nproc)" -n 8 clang++ "${flags[@]}" -fsyntax-only -x c++
xargs -P "$(nproc)" -n 8 clang++ "${flags[@]}" -include-pch "$work/eigen.pch" -fsyntax-only -x c++ < "$work/with_eigen"
printf '      %s headers, %s of them with Eigen\n' "$(wc -l < "$work/all")" "$(wc -l < "$work/with_eigen")" >&2
