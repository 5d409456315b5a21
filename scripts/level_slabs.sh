#!/usr/bin/env bash
# level_slabs.sh BUILD_FOLDER: imports axial slabs of 60, 90 and 120 mm every 20 mm of every shared CT, with and without
# labels, and checks that no path lies above L2/L3 or in cord and that every level that is named is named rightly. The
# test itself takes a dozen of them; this takes all.
set -euo pipefail
build=$(cd "$1" && pwd)
BODKIN_ALL_SLABS=1 "$build/tests/patient_from_ct_tests" --gtest_filter='LevelSlabs.*'
