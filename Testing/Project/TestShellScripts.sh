#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# No shell script has a warning of ShellCheck.
set -euo pipefail
cd "$1"
if ! command -v shellcheck >/dev/null || ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  echo "skipped: shellcheck and a git checkout are needed"
  exit 125
fi
git ls-files -z '*.sh' .ci/run | xargs -0 shellcheck --severity=warning
