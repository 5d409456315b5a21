#!/usr/bin/env bash
# check_headers.sh: every header of src/ compiles by itself, which the other builds do not show: they compile a module at
# once, or start from precompiled headers. Most of the time would go into what many headers include. So a few of those,
# the hubs, are compiled once, and a header that includes a hub, by itself or through others, starts from it.
set -euo pipefail
cd "$(dirname "$0")/.."
hubs=${1:-24}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
read -r -a window < <(pkg-config --cflags Qt5Widgets)
flags=(-std=c++20 -fPIC -Isrc -isystem /usr/include/eigen3 -isystem /usr/include/vtk-9.1
  "${window[@]}" -Wno-pragma-once-outside-header -w)

# in_parallel FUNCTION: calls it with the words of each line, on all cores.
in_parallel() { xargs -P "$(nproc)" -L 1 bash -c 'eval "$definitions"; "$0" "$@"' "$1"; }

# A line for each header: the hub that it starts from, or "-", and its name. The next hub is the one that spares most:
# for each header that reaches it, the files that it brings beyond those of the hub chosen for that header so far.
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

# precompile HUB, check START HEADER. What the inline functions of a hub instantiate is compiled with it, or each header
# would do that again: most of its time.
precompile() {
  clang++ "${flags[@]}" -fpch-instantiate-templates -x c++-header "src/$1" -o "$work/$(tr / . <<< "$1").pch"
}
check() {
  local from=()
  [ "$1" = - ] || from=(-include-pch "$work/$(tr / . <<< "$1").pch")
  clang++ "${flags[@]}" "${from[@]}" -fsyntax-only -x c++ "src/$2"
}
definitions=$(declare -p flags work; declare -f precompile check)
export definitions
awk '$1 != "-" {print $1}' "$work/all" | sort -u | in_parallel precompile
in_parallel check < "$work/all"
printf '      %s headers, %s of them from %s that many include\n' "$(wc -l < "$work/all")" \
  "$(grep -vc '^- ' "$work/all")" "$(awk '$1 != "-" {print $1}' "$work/all" | sort -u | wc -l)" >&2
