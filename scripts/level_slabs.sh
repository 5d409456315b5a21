#!/usr/bin/env bash
# level_slabs.sh BUILD_FOLDER: imports axial slabs of 60, 90 and 120 mm every 20 mm of every shared CT, with and
# without labels, and checks that no path lies above L2/L3 or in the cord and that every named level is correct. The
# test itself uses a dozen of them; this script uses all.
set -euo pipefail
build=$(cd "$1" && pwd)
BODKIN_ALL_SLABS=1 "$build/tests/patient_from_ct_tests" --gtest_filter='LevelSlabs.*'
