#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# formatting.sh CLANG_FORMAT SOURCE_DIR: our C++ outside OpenFOAM's own conventions is clang-formatted.
set -eu
cd "$2"
find src lammps-package liggghts-styles openfoam-coupling tests tools \
  \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 "$1" --dry-run --Werror
