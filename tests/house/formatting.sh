#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# formatting.sh CLANG_FORMAT SOURCE_DIR: our C++ outside OpenFOAM's own conventions is clang-formatted. Fails when there
# is no such program: scripts/setup installs it.
set -eu
command -v "$1" > /dev/null || { echo "no program '$1': apt-get install clang-format-19"; exit 1; }
cd "$2"
find src lammps-package liggghts-styles openfoam-coupling tests tools \
  \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 "$1" --dry-run --Werror
