# Sourced by ./run and ./test: installs missing packages, configures and builds. Says what it does, asks nothing, and
# does nothing twice.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
source scripts/packages.sh
export CCACHE_BASEDIR="$root" CCACHE_SLOPPINESS=pch_defines,time_macros

say() { printf '\033[1m==>\033[0m %s\033[2m [%d:%02d]\033[0m\n' "$*" $((SECONDS / 60)) $((SECONDS % 60)) >&2; }

# install_packages NAME...: installs those that are missing.
install_packages() {
  command -v dpkg-query >/dev/null || { say "this is not a Debian system; install by hand: $*"; return; }
  local missing=() package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  local become=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { say "these Debian packages are missing, and without root or sudo they cannot be installed: ${missing[*]}"; exit 1; }
    become=(sudo)
  fi
  say "installing ${#missing[@]} Debian packages: ${missing[*]}"
  "${become[@]}" apt-get update -q >&2
  "${become[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >&2
}

# build_preset PRESET [target...]: configures when that has not been done, then builds what is out of date.
build_preset() {
  local preset=$1; shift
  local launcher=()
  command -v ccache >/dev/null && launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  if [ ! -f "build/$preset/build.ninja" ]; then
    say "configuring build/$preset"
    cmake --preset "$preset" "${launcher[@]}" ${BODKIN_CMAKE_ARGUMENTS:-} >&2
  fi
  say "building build/$preset"
  cmake --build --preset "$preset" ${1:+--target "$@"} >&2
}
