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

# Headers of the core that the files given include, as paths from src/ on. A header of the core names others from src/
# on, or beside itself.
core_headers() {
  awk -F'"' '/^#include ".*"$/ { print FILENAME " " $2 }' "$@" | while read -r file header; do
    if [ -f "$core/$header" ]; then
      echo "$header"
      continue
    fi
    case $file in
      "$core"/*)
        folder=${file%/*}
        if [ -f "$folder/$header" ]; then echo "${folder#"$core"/}/$header"; fi ;;
    esac
  done | sort -u
}

rm -rf "$package"
mkdir -p "$package"
for room in "$here"/*/; do  # a package of LAMMPS is flat
  case $room in
    "$here"/plugin/) ;;  # LAMMPS finds the styles of a package by itself
    *)
      for ending in h cpp; do
        set -- "$room"*."$ending"
        if [ -f "$1" ]; then cp "$@" "$package"; fi
      done ;;
  esac
done

# Its own headers are included with their folder here, and without one there.
for header in "$here"/*/*.h; do
  folder=${header%/*}
  echo "s,^#include \"${folder##*/}/${header##*/}\",#include \"${header##*/}\","
done >"$package/flat.sed"
sed -i -f "$package/flat.sed" "$package"/*.h "$package"/*.cpp
rm "$package/flat.sed"

headers=$(core_headers "$package"/*.h "$package"/*.cpp)
while [ -n "$headers" ]; do
  set --
  for header in $headers; do
    [ -f "$package/$header" ] && continue
    copy=$package/$header
    [ -d "${copy%/*}" ] || mkdir -p "${copy%/*}"
    cp "$core/$header" "$copy"
    set -- "$@" "$core/$header"
  done
  headers=
  if [ $# -gt 0 ]; then headers=$(core_headers "$@"); fi
done

if ! grep -qx '  COHESION' "$list"; then
  sed -i 's/^set(STANDARD_PACKAGES$/&\n  COHESION/' "$list"
  grep -qx '  COHESION' "$list" || fail "could not add COHESION to the packages of '$list'"
fi
echo "package COHESION is in $package; configure LAMMPS with -DPKG_COHESION=ON"
