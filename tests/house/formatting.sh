#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# formatting.sh CLANG_FORMAT SOURCE_DIR: our C++ is clang-formatted, by the .clang-format of its folder. Files in
# OpenFOAM's conventions (.H, .C) lie where that disables it, and have the opening brace of a scope on its own line.
# Fails when there is no such program: scripts/setup installs it.
set -eu
command -v "$1" > /dev/null || { echo "no program '$1': apt-get install clang-format-19"; exit 1; }
cd "$2"
find src lammps-package liggghts-styles openfoam-coupling tests tools \
  \( -name '*.h' -o -name '*.cpp' -o -name '*.H' -o -name '*.C' \) -print0 | xargs -0 "$1" --dry-run --Werror
if grep -rnE --include='*.[HC]' '^(namespace|class|struct|enum) .*\{$' openfoam-coupling; then
  echo "These lines are not in OpenFOAM's conventions."
  exit 1
fi
