# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Reads arguments, for the scripts that source this file.
# shellcheck shell=bash disable=SC2034

# Prints the comment at the top of the running script, without the licence.
print_help() {
  sed -n '5,/^set /{ /^set /d; s/^# \{0,1\}//; p; }' "$0"
}

# Rejects an argument of the running script.
reject_argument() {
  echo "${0##*/}: error: unknown argument $1; --help lists the arguments" >&2
  exit 2
}

# read_arguments ARGUMENT...
#
# Sets install to yes, or to no with --no-install, and other_arguments to the other arguments. --help
# prints the help and ends the script.
read_arguments() {
  install=yes
  other_arguments=()
  local argument
  for argument in "$@"; do
    case $argument in
      --no-install) install=no ;;
      -h | --help)
        print_help
        exit 0
        ;;
      *) other_arguments+=("$argument") ;;
    esac
  done
}
