#!/usr/bin/env bash
# fuzz.sh BUILD_FOLDER SECONDS: runs every fuzz target for SECONDS from its seeds in fuzz/corpus. Fails on the first
# crash, leak, hang or excessive allocation and leaves the offending input beside the target.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build=$(cd "$1" && pwd)
seconds=$2
targets=("$build"/fuzz/*_fuzz)
[ -x "${targets[0]}" ] || { echo "fuzz.sh: no fuzz targets in $build/fuzz" >&2; exit 1; }
for target in "${targets[@]}"; do
  name=$(basename "$target" _fuzz)
  found="$build/fuzz/found/$name"
  mkdir -p "$found"
  echo "--- $name, $seconds s"
  (cd "$build/fuzz" && "$target" "$found" "$root/fuzz/corpus/$name" -max_total_time="$seconds" -timeout=10 \
    -rss_limit_mb=2048 -max_len=65536 -print_final_stats=1 -verbosity=0 -close_fd_mask=1 2>&1 | tail -n 12)
done
