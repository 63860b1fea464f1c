#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# No file has a misspelled word.
set -euo pipefail
cd "$1"
if ! command -v codespell >/dev/null || ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  echo "skipped: codespell and a git checkout are needed"
  exit 125
fi
git ls-files -z ':!*.png' ':!*.jpg' ':!*.vtp' | xargs -0 codespell
