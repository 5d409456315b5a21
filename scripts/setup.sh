# Sourced by ./run and ./test: installs missing packages, configures and builds. Reports its actions, asks nothing, and
# repeats nothing.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
source scripts/packages.sh
export CCACHE_BASEDIR="$root" CCACHE_SLOPPINESS=pch_defines,time_macros

say() { printf '\033[1m==>\033[0m %s\033[2m [%d:%02d]\033[0m\n' "$*" $((SECONDS / 60)) $((SECONDS % 60)) >&2; }

# missing_packages NAME...: packages that are not installed, one per line.
missing_packages() {
  printf '%s\n' "$@" | sort -u | comm -23 - \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^installed //p' | sort -u)
}

# install_packages NAME...: installs the missing ones, after reporting their number and size. Upgrades a package only
# if a missing one requires a newer version.
install_packages() {
  command -v dpkg-query >/dev/null || { say "this is not a Debian system; install by hand: $*"; return; }
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -eq 0 ] && return
  local become=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { say "these Debian packages are missing, and without root or sudo they cannot be installed: ${missing[*]}"; exit 1; }
    become=(sudo)
  fi
  local install=(apt-get install --no-upgrade --no-install-recommends)
  say "${#missing[@]} Debian packages are missing: ${missing[*]}"
  "${become[@]}" apt-get update -qq >&2
  say "installing them and what they need:"
  LC_ALL=C "${install[@]}" --assume-no "${missing[@]}" 2>/dev/null |
    sed -n -E 's/^([0-9]+ upgraded|Need to get|After this).*/      &/p' >&2 || true
  # One line for each package would hide everything else; apt's output is shown on failure.
  local log
  log=$(mktemp)
  "${become[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}" -y -q "${missing[@]}" > "$log" 2>&1 &
  show_progress $! "$log" '^Setting up ' || { cat "$log" >&2; say "apt-get failed; what it said stands above"; exit 1; }
  rm -f "$log"
}

# show_progress PROCESS LOG PATTERN: counts the matching lines of LOG until PROCESS ends; only on a terminal.
show_progress() {
  while [ -t 2 ] && kill -0 "$1" 2>/dev/null; do
    printf '\r      %s packages are set up ' "$(grep -c "$3" "$2")" >&2
    sleep 1
  done
  [ ! -t 2 ] || printf '\r\033[K' >&2
  wait "$1"
}

# with_large_pages COMMAND...: the C library gives the command, a compiler, memory in large pages and large pieces.
# Compilers fill gigabytes, and a virtual machine takes a tenth of their time to provide them page by page.
with_large_pages() {
  local megabyte=$((1 << 20)) malloc=glibc.malloc
  GLIBC_TUNABLES="$malloc.hugetlb=1:$malloc.top_pad=$((64 * megabyte)):$malloc.mmap_threshold=$((1024 * megabyte)):\
$malloc.trim_threshold=$((4096 * megabyte))" "$@"
}

# configure_preset PRESET: configures it unless already done.
configure_preset() {
  [ ! -f "build/$1/build.ninja" ] || return 0
  local launcher=()
  command -v ccache >/dev/null && launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  say "configuring build/$1"
  cmake --preset "$1" "${launcher[@]}" ${BODKIN_CMAKE_ARGUMENTS:-} >"build-$1.log" 2>&1 ||
    { cat "build-$1.log" >&2; rm -f "build-$1.log"; return 1; }
  rm -f "build-$1.log"
}

# build_preset PRESET [target...]: configures it unless already done, then builds outdated targets.
build_preset() {
  local preset=$1; shift
  configure_preset "$preset"
  say "building build/$preset"
  with_large_pages cmake --build --preset "$preset" ${1:+--target "$@"} >&2
}
