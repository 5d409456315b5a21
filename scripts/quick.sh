#!/usr/bin/env bash
# quick.sh [MODULE...]: the tests of these modules; without modules, of those that differ from origin/main and of their
# dependents. Builds file by file with precompiled headers (preset dev), and leaves out the tests in
# tests/slow_tests.txt, all sanitizers, and clang-tidy: the whole ./test runs those.
source "$(dirname "$0")/setup.sh"
install_packages "${packages_to_run[@]}" "${packages_of_app[@]}" "${packages_to_test[@]}"
unset BODKIN_CMAKE_ARGUMENTS

# changed_files: files that differ from the common ancestor with origin/main, committed or not, including new files.
changed_files() {
  local since
  since=$(git merge-base HEAD origin/main 2>/dev/null) || since=HEAD
  { git diff --name-only "$since"; git ls-files --others --exclude-standard; } | sort -u
}

configure_preset dev
mapfile -t changed < <(changed_files)
if [ $# -gt 0 ]; then
  own=("$@")
  sources=()
else
  mapfile -t own < <(printf '%s\n' "${changed[@]}" | sed -n -E 's#^(src|tests)/([a-z]+)/.*#\2#p' | sort -u)
  mapfile -t sources < <(printf '%s\n' "${changed[@]}" | sed -n -E 's#^src/([a-z]+)/.*#\1#p' | sort -u)
  if [ ${#own[@]} -eq 0 ]; then
    say "no file below src/ or tests/ differs from origin/main; name a module: ./test quick forces"
    exit
  fi
fi
own=("${own[@]/#programs/cli}")  # its helper programs are tested through the command

# programs FIELDS MODULE...: the test programs that have one of the modules in these fields of their line.
programs() {
  local fields=$1; shift
  awk -v wanted="$*" -v last="$fields" 'BEGIN { n = split(wanted, w); for (i = 1; i <= n; ++i) is_wanted[w[i]] = 1 }
    { for (i = 2; i <= (last ? last : NF); ++i) if (is_wanted[$i]) { print $1; next } }' build/dev/test_programs.txt
}

mapfile -t first < <({ programs 2 "${own[@]}"; echo layout; } | sort -u)
if [ $# -gt 0 ] && [ "$(programs 2 "$@" | wc -l)" -eq 0 ]; then
  say "there is no module '$*' with tests; the modules are: $(cut -d ' ' -f 2 build/dev/test_programs.txt | sort -u | xargs)"
  exit 2
fi
mapfile -t second < <({ [ ${#sources[@]} -eq 0 ] || programs 0 "${sources[@]}"; } | sort -u |
  comm -23 - <(printf '%s\n' "${first[@]}"))

if command -v clang-format >/dev/null && [ ${#changed[@]} -gt 0 ]; then
  for file in "${changed[@]}"; do
    case $file in *.cpp | *.h) [ ! -f "$file" ] || echo "$file" ;; esac
  done | xargs -r clang-format --dry-run --Werror
fi

# build_and_test WHAT PROGRAM...
build_and_test() {
  local what=$1; shift
  [ $# -gt 0 ] || return 0
  say "$what: $*"
  with_large_pages cmake --build --preset dev --target "${@/%/_tests}" >build/dev/quick.log 2>&1 || { cat build/dev/quick.log >&2; return 1; }
  rm -rf build/dev/test_times
  ctest --preset dev -j "$(nproc)" --no-tests=error -LE 'slow|release_only' \
    -R "^($(IFS='|'; echo "${*//./\\.}"))\.[0-9]+$" >build/dev/quick.log 2>&1 ||
    { grep -v -E '^ +Start|\.+ +Passed' build/dev/quick.log >&2; return 1; }
  sed -n 's/^100%/      100%/p' build/dev/quick.log >&2
}

build_and_test "tests of what changed" "${first[@]}"
build_and_test "tests of what stands on it" "${second[@]}"
say "passed in $SECONDS s; slow tests, sanitizers and clang-tidy are left to ./test"
