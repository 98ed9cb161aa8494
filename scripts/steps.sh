# SPDX-License-Identifier: BSD-3-Clause
# Shared by the scripts: where things are, and steps that say what they do and how long they took.
# shellcheck shell=bash

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

# step "what it does" "how long it takes the first time" command...
step() {
  local what=$1 expected=$2 begin=$SECONDS
  shift 2
  printf '==> %s (%s the first time)\n' "$what" "$expected"
  "$@" || fail "$what"
  printf '    done in %d s\n' $((SECONDS - begin))
}

fail() {
  printf 'FAILED: %s\n' "$1" >&2
  exit 1
}

# Downloads fail now and then: up to three times.
retry() {
  local attempt
  for attempt in 1 2 3; do
    "$@" && return 0
    sleep $((attempt * 5))
  done
  return 1
}

# logged LOG command...: quiet unless it fails
logged() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  if ! "$@" >"$log" 2>&1; then
    tail -n 30 "$log"
    printf 'the whole log: %s\n' "$log"
    return 1
  fi
}
