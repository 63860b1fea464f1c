#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# codespell finds no misspelled word.
set -euo pipefail
cd "$1"
if ! command -v codespell >/dev/null || ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  echo "skipped: codespell or a git checkout is missing"
  exit 125
fi
git ls-files -z ':!*.png' ':!*.jpg' ':!*.vtp' ':!*.ipynb' | xargs -0 codespell
# Notebooks contain pictures as text.
git ls-files -z '*.ipynb' | xargs -0 grep -hv '"image/png"' | codespell -
