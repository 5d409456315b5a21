#!/usr/bin/env bash
# slowest_tests.sh BUILD_FOLDER [COUNT]: the tests that took the longest in the last run there, in seconds.
set -euo pipefail
for file in "$1"/test_times/*.xml; do
  program=$(basename "$file" .xml)
  sed -n -E "s/.*<testcase name=\"([^\"]*)\".* time=\"([0-9.]+)\".* classname=\"([^\"]*)\".*/\2 ${program%.*} \3.\1/p" "$file"
done | sort -rn | awk -v count="${2:-10}" 'NR <= count {printf "      %7.1f s  %-20s %s\n", $1, $2, $3}'
