#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
# No tracked file is larger than 1 MB, or contains a path of a developer's machine or a package
# mirror. The top folder has only the listed files.
set -euo pipefail
cd "$1"
if ! git rev-parse --is-inside-work-tree >/dev/null 2>&1; then
  echo "skipped: not a git checkout"
  exit 125
fi
failed=0
report() {
  echo "$1"
  failed=1
}

# Brackets keep these expressions from matching this file.
folders='(^|[^A-Za-z0-9_.}~-])/(home|root|work|tmp|Users|mnt|media)/[A-Za-z0-9]'
hosts='https?://[a-z0-9.-]*(deb[.]debian|snapshot[.]debian|archive[.]ubuntu|pypi|pythonhosted|npmjs|crates[.]io|proxy[.]golang)'
while IFS= read -r -d '' file; do
  if [ ! -f "$file" ]; then
    continue
  fi
  if [ "$(stat -c %s "$file")" -gt 1000000 ]; then
    report "$file: is larger than 1 MB"
  fi
  if grep -InE "$folders|$hosts" "$file" /dev/null; then
    report "$file: contains a local path or a package mirror"
  fi
  case ${file%%/*} in
    .ci | .clang-format | .clang-tidy | .codespellrc | .editorconfig | .gitattributes | .github) ;;
    .gitignore | .pre-commit-config.yaml | CHANGELOG.md | CITATION.cff) ;;
    CMakeLists.txt | CMakePresets.json | CODE_OF_CONDUCT.md | SECURITY.md | pyproject.toml) ;;
    CONTRIBUTING.md | Data | Examples | Filters | LICENSE | Module | README.md | Rendering | Testing) ;;
    *) report "$file: is not listed for the top folder in TestTrackedFiles.sh" ;;
  esac
  case $file in
    *.h | *.cxx)
      if ! grep -q 'SPDX-License-Identifier: BSD-3-Clause' "$file"; then
        report "$file: has no SPDX-License-Identifier"
      fi
      ;;
  esac
done < <(git ls-files -z)
exit $failed
