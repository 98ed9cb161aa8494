# SPDX-License-Identifier: BSD-3-Clause
# Shared by the scripts: where things are, and steps that say what they do and how long they took.
# shellcheck shell=bash

shopt -s inherit_errexit # `set -e` in $(...) too
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cache=${COHESION_CACHE:-$HOME/.cache/cohesion}
build=${COHESION_BUILD:-$repository/build}
cores=$(nproc)
python=/usr/bin/python3 # Debian's, the one that has Debian's numpy

if [ "$(id -u)" = 0 ]; then
  as_root=()
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
else
  as_root=(sudo)
fi

# attempt command...: its exit code is in `status` afterwards. `set -e` holds in all of the command; after `if`, `!` or
# `&&` and before `||` it would not, and what fails in the middle would count as done. For that reason attempt, step,
# retry and logged are not to be called in such places either.
attempt() {
  set +e
  (
    set -e
    "$@"
  )
  status=$?
  set -e
}

# step "what it does" "how long it takes the first time" command...
step() {
  local what=$1 expected=$2 begin=$SECONDS
  shift 2
  printf '==> %s (%s the first time)\n' "$what" "$expected"
  attempt "$@"
  [ "$status" = 0 ] || fail "$what"
  printf '    done in %d s\n' $((SECONDS - begin))
}

fail() {
  printf 'FAILED: %s\n' "$1" >&2
  exit 1
}

# What the last configuration left out, a line each with the reason
left_out() {
  sed -n 's/^  \(.*\): left out, /\1: /p' "$build/summary.txt"
}

# Once all that is needed has been installed, what CMake leaves out, unless it was switched off, is a failure.
# The current and the newest LAMMPS are for tests alone.
require_complete() {
  local missing
  missing=$(left_out | sed '/^\(current\|newest\) LAMMPS: /d; / is OFF$/d')
  [ -z "$missing" ] || {
    printf 'left out, though all was installed:\n%s\n' "$missing"
    return 1
  }
}

# Downloads fail now and then: up to three times.
retry() {
  local turn
  for turn in 1 2 3; do
    attempt "$@"
    [ "$status" != 0 ] || return 0
    [ "$turn" = 3 ] || sleep $((turn * 5))
  done
  return 1
}

# logged LOG command...: quiet unless it fails
logged() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  attempt "$@" >"$log" 2>&1
  [ "$status" != 0 ] || return 0
  tail -n 30 "$log"
  printf 'the whole log: %s\n' "$log"
  return 1
}
