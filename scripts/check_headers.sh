#!/usr/bin/env bash
# check_headers.sh: checks that every header of src/ compiles by itself, which other builds do not: they compile a
# module at once, or use precompiled headers. Most of the time would go into commonly included headers. So a few of
# these, the hubs, are precompiled, and a header that includes a hub, directly or indirectly, starts from it.
set -euo pipefail
cd "$(dirname "$0")/.."
hubs=${1:-24}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
read -r -a window < <(pkg-config --cflags Qt5Widgets)
flags=(-std=c++20 -fPIC -Isrc -isystem /usr/include/eigen3 -isystem /usr/include/vtk-9.1
  "${window[@]}" -Wno-pragma-once-outside-header -w)

# in_parallel FUNCTION: calls FUNCTION with the words of each line, on all cores.
in_parallel() { xargs -P "$(nproc)" -L 1 bash -c 'eval "$definitions"; "$0" "$@"' "$1"; }

# A line for each header: its hub, or "-", and its name. The next hub is the one that saves most: for each header that
# reaches it, the number of its files beyond those of that header's present hub.
git ls-files 'src/*.h' | xargs awk -v hubs="$hubs" '
  FNR == 1 { header = substr(FILENAME, 5); headers[++count] = header }
  /^#include [<"]/ { split($2, part, /[<>"]/); includes[header] = includes[header] " " part[2] }
  function visit(file, from,    names, n, i) {
    if ((from, file) in seen) return
    seen[from, file] = 1
    size[from] += file ~ /^Eigen/ ? 40 : file ~ /^(Q|vtk)/ ? 10 : 1
    if (file != from && file in is_header) reached[from] = reached[from] " " file
    n = split(includes[file], names, " ")
    for (i = 1; i <= n; ++i) visit(names[i], from)
  }
  END {
    for (i = 1; i <= count; ++i) is_header[headers[i]] = 1
    for (i = 1; i <= count; ++i) visit(headers[i], headers[i])
    for (k = 0; k < hubs; ++k) {
      split("", spares)
      for (i = 1; i <= count; ++i) {
        n = split(reached[headers[i]], names, " ")
        for (j = 1; j <= n; ++j) {
          gain = size[names[j]] - best[headers[i]]
          if (gain > 0) spares[names[j]] += gain
        }
      }
      most = 0
      for (hub in spares) if (spares[hub] - size[hub] > most) { most = spares[hub] - size[hub]; chosen = hub }
      if (most == 0) break
      for (i = 1; i <= count; ++i)
        if (((headers[i], chosen) in seen) && headers[i] != chosen && size[chosen] > best[headers[i]]) {
          best[headers[i]] = size[chosen]
          start[headers[i]] = chosen
        }
    }
    for (i = 1; i <= count; ++i) print start[headers[i]] == "" ? "-" : start[headers[i]], headers[i]
  }' > "$work/all"

# precompile HUB, check START HEADER... Templates used by the inline functions of a hub are instantiated with it;
# otherwise each header would repeat that, at most of its cost. Headers with one start share a process, because the
# compiler takes longer to start than to read most of them; each is still a source file of its own.
precompile() {
  clang++ "${flags[@]}" -fpch-instantiate-templates -x c++-header "src/$1" -o "$work/$(tr / . <<< "$1").pch"
}
check() {
  local from=() words compiler=() word
  [ "$1" = - ] || from=(-include-pch "$work/$(tr / . <<< "$1").pch")
  shift
  # The command that the driver would run, with all headers instead of its last word, the source file. Without
  # -disable-free the memory of each header is freed before the next one is read.
  eval "words=($(clang++ "${flags[@]}" "${from[@]}" -fsyntax-only -x c++ "src/$1" -### 2>&1 | tail -n 1))"
  for word in "${words[@]}"; do [ "$word" = -disable-free ] || compiler+=("$word"); done
  unset 'compiler[-1]'
  "${compiler[@]}" "${@/#/src/}"
}
definitions=$(declare -p flags work; declare -f precompile check)
export definitions
awk '$1 != "-" {print $1}' "$work/all" | sort -u | in_parallel precompile
sort "$work/all" | awk -v most=10 '
  $1 != start || count == most { if (NR > 1) print ""; printf "%s", $1; start = $1; count = 0 }
  { printf " %s", $2; ++count }
  END { print "" }' | in_parallel check
printf '      %s headers, %s of them from %s that many include\n' "$(wc -l < "$work/all")" \
  "$(grep -vc '^- ' "$work/all")" "$(awk '$1 != "-" {print $1}' "$work/all" | sort -u | wc -l)" >&2
