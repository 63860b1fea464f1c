#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds and runs all tests. The output ends with ctest's summary. The exit code is 0 only if all
# tests passed. Arguments are passed to ctest:
#
#   bash Testing/run.sh [-R NAME] [-L Filters|Rendering|Python|Project] [...]
#
# RELEVO_TEST_DATA names a folder of larger real data. Tests that need it are skipped without it.
set -euo pipefail

source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${RELEVO_BUILD_DIR:-$source_dir/build}

data=()
if [ -n "${RELEVO_TEST_DATA:-}" ]; then
  data=("-DRELEVO_TEST_DATA=$(cd "$RELEVO_TEST_DATA" && pwd)")
fi
bash "$source_dir/Module/build.sh" --testing --benchmark -DRELEVO_WERROR=ON "${data[@]}"

# All tests share an X server. Without -noreset it would reset when the last window closes.
display=()
if [ -z "${DISPLAY:-}" ]; then
  display=(xvfb-run -a -s "-noreset -screen 0 1280x1024x24")
fi
cd "$build_dir"
built=$SECONDS
log=Testing/Temporary/run.log
mkdir -p "${log%/*}"
result=0
"${display[@]}" ctest --output-on-failure --parallel "$(nproc)" "$@" | tee "$log" || result=$?

# The summary comes last, because the list of tests is long.
echo
echo "The build took $built s, the tests $((SECONDS - built)) s. The slowest tests:"
sed -n 's/^"\(.*\)" time elapsed: \(.*\)/  \2  \1/p' Testing/Temporary/LastTest.log |
  sort -r | sed -n 1,15p
echo
sed -n '/tests passed/,$p' "$log"
exit "$result"
