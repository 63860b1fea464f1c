#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# ShellCheck has no warnings for the shell scripts.
set -euo pipefail
cd "$1"
if ! command -v shellcheck >/dev/null || ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  echo "skipped: shellcheck or a git checkout is missing"
  exit 125
fi
git ls-files -z '*.sh' .ci/run | xargs -0 shellcheck --severity=warning
