#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# All C++ files follow .clang-format.
set -euo pipefail
cd "$1"
if ! command -v clang-format >/dev/null; then
  echo "skipped: clang-format is not installed"
  exit 125
fi
# Releases of clang-format format differently. The test uses that of Debian 12.
if ! clang-format --version | grep -q 'version 14\.'; then
  echo "skipped: clang-format is not version 14"
  exit 125
fi
if git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  git ls-files -z '*.h' '*.cxx'
else
  find Examples Filters Rendering Testing \( -name '*.h' -o -name '*.cxx' \) -print0
fi | xargs -0 clang-format --dry-run -Werror
