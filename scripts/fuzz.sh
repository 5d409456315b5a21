#!/usr/bin/env bash
# fuzz.sh BUILD_FOLDER SECONDS: runs every fuzz target for SECONDS from its seeds in fuzz/corpus, in parallel on all
# cores. Fails on the first crash, leak, hang or excessive allocation and leaves the offending input next to the
# target.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
seconds=$2
targets=("$build"/fuzz/*_fuzz)
[ -x "${targets[0]}" ] || { echo "fuzz.sh: no fuzz targets in $build/fuzz" >&2; exit 1; }
run_one() {
  local target=$1 name found
  name=$(basename "$target" _fuzz)
  found="$build/fuzz/found/$name"
  mkdir -p "$found"
  cd "$build/fuzz"
  local said
  said=$("$target" "$found" "$root/fuzz/corpus/$name" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=65536 -print_final_stats=1 -verbosity=0 -close_fd_mask=1 2>&1 | tail -n 12) ||
    { printf -- '--- %s failed\n%s\n' "$name" "$said"; return 1; }
  printf -- '--- %s, %s s: %s inputs\n' "$name" "$seconds" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' <<<"$said")"
}
export -f run_one
export build root seconds
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I{} bash -euo pipefail -c 'run_one {}'
