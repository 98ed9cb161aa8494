#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-only
# install-into-tree.sh LAMMPS_SOURCE_DIR
#
# Puts the package into a LAMMPS source tree, as src/COHESION with the core headers that it needs,
# and adds its name to the tree's list of packages. Then configure LAMMPS with -DPKG_COHESION=ON
# (and -DCMAKE_CXX_STANDARD=17 where LAMMPS' default is older). A second call brings the copy up to
# date.
set -eu

fail() { echo "install-into-tree.sh: $1" >&2; exit 1; }

[ $# -eq 1 ] || fail "takes one argument, the folder of a LAMMPS source tree"
tree=$1
list=$tree/cmake/CMakeLists.txt
[ -f "$tree/src/lammps.h" ] || fail "'$tree' is no LAMMPS source tree: it has no src/lammps.h"
[ -f "$list" ] || fail "'$tree' cannot be built with CMake: it has no cmake/CMakeLists.txt"
grep -q '^set(STANDARD_PACKAGES' "$list" ||
  fail "'$list' has no line 'set(STANDARD_PACKAGES'; add COHESION to its packages by hand"

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
core=$here/../src
package=$tree/src/COHESION

# Headers of the core that the files given include, one level of nesting after the other.
core_headers() {
  sed -n 's/^#include "\(.*\)"$/\1/p' "$@" | sort -u | while read -r header; do
    if [ -f "$core/$header" ]; then echo "$header"; fi
  done
}

rm -rf "$package"
mkdir -p "$package"
for file in "$here"/*/*.h "$here"/*/*.cpp; do  # a package of LAMMPS is flat
  case $file in
    "$here"/plugin/*) ;;  # LAMMPS finds the styles of a package by itself
    *) cp "$file" "$package" ;;
  esac
done

headers=$(core_headers "$package"/*.h "$package"/*.cpp)
while [ -n "$headers" ]; do
  next=
  for header in $headers; do
    [ -f "$package/$header" ] && continue
    mkdir -p "$package/$(dirname "$header")"
    cp "$core/$header" "$package/$header"
    folder=$(dirname "$header")
    # A header names others from src/ on, or beside itself.
    for found in $(sed -n 's/^#include "\(.*\)"$/\1/p' "$core/$header"); do
      if [ -f "$core/$found" ]; then
        next="$next $found"
      elif [ -f "$core/$folder/$found" ]; then
        next="$next $folder/$found"
      fi
    done
  done
  headers=$next
done

if ! grep -qx '  COHESION' "$list"; then
  sed -i 's/^set(STANDARD_PACKAGES$/&\n  COHESION/' "$list"
  grep -qx '  COHESION' "$list" || fail "could not add COHESION to the packages of '$list'"
fi
echo "package COHESION is in $package; configure LAMMPS with -DPKG_COHESION=ON"
