# SPDX-License-Identifier: BSD-3-Clause
# Fetches engine sources through the machine's own Debian archive, into the cache.
# shellcheck shell=bash disable=SC2154

# Address of the Debian archive that this machine installs from: others may use Debian's code names,
# and a disc has no sources.
archive() {
  # shellcheck disable=SC2016 # apt's own variables
  apt-get indextargets --format '$(REPO_URI) $(LABEL) $(CODENAME) $(COMPONENT)' \
    'Created-By: Packages' 'Origin: Debian' |
    awk -v wanted="Debian $(codename) main" '$1 !~ /^cdrom:/ && $2 " " $3 " " $4 == wanted && !found++ \
      {print $1}'
}

# fetch_source PACKAGE SUITE FOLDER: the upstream tarball of a source package. apt gets lists and
# state of its own, so that the machine's configuration stays as it is. Signatures are checked.
fetch_source() {
  local package=$1 suite=$2 folder=$3 uri apt listed tarball checksum
  uri=$(archive)
  if [ -z "$uri" ]; then
    # Without lists apt does not know its archives.
    retry logged "$cache/logs/apt-update" "${as_root[@]}" apt-get update
    uri=$(archive)
  fi
  [ -n "$uri" ] || { echo "no Debian archive in apt's configuration"; return 1; }
  mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial"
  echo "deb-src $uri $suite main" >"$folder/apt/sources.list"
  apt=(apt-get -o "Dir::Etc::sourcelist=$folder/apt/sources.list" -o Dir::Etc::sourceparts=/dev/null
    -o "Dir::State::lists=$folder/apt/lists" -o Dir::State::status=/dev/null
    -o "Dir::Cache=$folder/apt/cache" -o APT::Sandbox::User="$(id -un)")
  retry "${apt[@]}" -o APT::Update::Error-Mode=any update
  # An archive may lack a small file of a source package and apt then fails: the upstream tarball
  # is enough, if its size and checksum are those of the archive's signed index.
  listed=$("${apt[@]}" --only-source source --print-uris "$package" |
    awk '$2 ~ /\.orig\.tar\.[a-z0-9]+$/ && !found++ {print $2, $4}')
  read -r tarball checksum <<<"$listed"
  checksum=${checksum#SHA256:}
  [ -n "$checksum" ] || { echo "no source package $package in $suite"; return 1; }
  retry download_tarball
  rm -rf "$folder/apt"
}

# The rest of fetch_source, with its variables: leaves the checked tarball in the folder.
download_tarball() {
  (cd "$folder" && "${apt[@]}" --only-source source --download-only "$package") || true
  echo "$checksum  $folder/$tarball" | sha256sum --check
}

upstream_tarball() {
  find "$2" -maxdepth 1 -name "$1_*.orig.tar.*" ! -name '*.asc'
}

# unpack PACKAGE FOLDER TREE words-for-tar...: the tarball in a folder, into a tree that has src/, whether or not the
# tarball has a folder of its own around it all. The tarball is gone afterwards.
unpack() {
  local tarball sources
  tarball=$(upstream_tarball "$1" "$2")
  mkdir -p "$2/unpacked" "$3"
  tar -xf "$tarball" -C "$2/unpacked" "${@:4}"
  sources=("$2"/unpacked{,/*}/src)
  sources=("${sources[@]%/src}")
  [ -d "${sources[0]}/src" ] || sources=("${sources[@]:1}")
  [ -d "${sources[0]}/src" ] || { echo "$tarball has no src/, neither at its top nor in a folder"; return 1; }
  mv -t "$3" "${sources[0]}"/*
  rm -rf "$2/unpacked" "$tarball"
}

# An entry of /etc/os-release; empty when it has none of that name
os_release() {
  # shellcheck disable=SC1091
  (. /etc/os-release && echo "${!1:-}")
}

codename() {
  os_release VERSION_CODENAME
}

require_known_debian() {
  case "$(codename)" in
    bookworm | trixie) return 0 ;;
  esac
  fail "these scripts know the packages of Debian 12 (bookworm) and 13 (trixie), and this is $(os_release PRETTY_NAME).
Run them in a container or a chroot of one of the two, for instance made by 'debootstrap trixie FOLDER', or install
the engines and their headers yourself and build with CMake: docs/building.md"
}

# Upstream version of the package that has an installed library. Packages of libraries change their names from one
# Debian to the next, and of a name that it has heard of dpkg-query prints an empty version and calls that a success.
installed() {
  local owner version
  owner=$(dpkg-query -S "*/$1" | sed -n '1s/: .*//p')
  version=$(dpkg-query -W -f='${source:Upstream-Version}' "$owner")
  [ -n "$version" ] || { echo "package '$owner' of $1 has no version" >&2; return 1; }
  echo "$version"
}

# fetch_headers PACKAGE VERSION FOLDER: the tarball of just that version. Headers of another one
# would compile and then crash.
fetch_headers() {
  logged "$cache/logs/$1-source" fetch_source "$1" "$(codename)" "$3"
  [[ $(upstream_tarball "$1" "$3") = "$3/$1_$2.orig.tar."* ]] || {
    echo "$1 $2 is installed, but the archive has the source of $(upstream_tarball "$1" "$3")"
    return 1
  }
}

# Whether a folder's headers are those of a version
has_version() {
  [ -e "$1/done" ] && [ "$(cat "$1/done")" = "$2" ]
}

fetch_lammps_headers() {
  local folder=$cache/lammps-stock version
  version=$(installed liblammps.so)
  ! has_version "$folder" "$version" || return 0
  rm -rf "$folder"
  mkdir -p "$folder"
  fetch_headers lammps "$version" "$folder"
  unpack lammps "$folder" "$folder" --wildcards '*/src/*.h'
  echo "$version" >"$folder/done"
}

# OpenFOAM's sources include each other's headers through one flat folder of links per library.
link_headers() {
  local source=$1 folder=$2
  mkdir -p "$folder"
  find "$source" \( -name lnInclude -o -name Make -o -name config -o -name noLink \) -prune -o \
    \( -name '*.[CHh]' \) -type f -print0 | xargs -0 ln -sf -t "$folder"
}

fetch_openfoam_headers() {
  local folder=$cache/openfoam-stock solver=applications/solvers/multiphase/twoPhaseEulerFoam version module
  version=$(installed libOpenFOAM.so)
  # Another set of headers may be there, of an earlier version of the package.
  if has_version "$folder" "$version" && [ -d "$folder/lnInclude/twoPhase" ]; then
    return 0
  fi
  rm -rf "$folder"
  mkdir -p "$folder"
  fetch_headers openfoam "$version" "$folder"
  unpack openfoam "$folder" "$folder/source" --wildcards '*/src/OpenFOAM' '*/src/OSspecific/POSIX' \
    '*/src/finiteVolume' '*/src/meshTools' '*/src/lagrangian/basic' '*/src/TurbulenceModels' \
    '*/src/transportModels/incompressible' '*/src/transportModels/compressible' '*/src/thermophysicalModels/basic' \
    "*/$solver"
  for module in OpenFOAM finiteVolume meshTools; do
    link_headers "$folder/source/src/$module" "$folder/lnInclude/$module"
  done
  link_headers "$folder/source/src/OSspecific/POSIX" "$folder/lnInclude/OSspecific"
  link_headers "$folder/source/src/lagrangian/basic" "$folder/lnInclude/lagrangian"
  for module in turbulenceModels incompressible; do
    link_headers "$folder/source/src/TurbulenceModels/$module" "$folder/lnInclude/turbulence"
  done
  # What the models of twoPhaseEulerFoam are made of, of which a library can bring more
  for module in thermophysicalModels/basic transportModels/{incompressible/transportModel,compressible}; do
    link_headers "$folder/source/src/$module" "$folder/lnInclude/twoPhase"
  done
  for module in twoPhaseSystem interfacialModels phaseCompressibleTurbulenceModels; do
    link_headers "$folder/source/$solver/$module" "$folder/lnInclude/twoPhase"
  done
  echo "${version%%.*}" >"$folder/api"
  echo "$version" >"$folder/done"
}

# build_lammps NAME SUITE: another LAMMPS to test against. Not to be had is no failure: the tests and CMake's summary say
# so and go on without it.
build_lammps() {
  local folder=$cache/lammps-$1
  [ ! -e "$folder/done" ] || return 0
  rm -rf "$folder"
  mkdir -p "$folder"
  attempt make_lammps "$1" "$2" "$folder"
  [ "$status" = 0 ] || return 0
  rm -f "$folder.missing"
  touch "$folder/done"
}

build_current_lammps() {
  if [ "${COHESION_CURRENT_LAMMPS:-yes}" = yes ] || [ -e "$cache/lammps-current/done" ]; then
    build_lammps current trixie
  else
    skip_lammps current "COHESION_CURRENT_LAMMPS is not 'yes'"
  fi
}

# In a folder; fails when it has said why there is none.
make_lammps() {
  local log=$cache/logs/lammps-$1
  or_skip "$1" "its source could not be fetched, see $log-source" \
    logged "$log-source" fetch_source lammps "$2" "$3"
  or_skip "$1" "its source could not be unpacked" unpack lammps "$3" "$3" \
    --exclude=doc --exclude=examples --exclude=potentials --exclude=bench
  or_skip "$1" "it could not be built, see $log-build" logged "$log-build" compile_lammps "$3"
}

# or_skip NAME REASON command...
or_skip() {
  local name=$1 reason=$2
  shift 2
  attempt "$@"
  [ "$status" != 0 ] || return 0
  skip_lammps "$name" "$reason"
  return 1
}

# Compiled in two thirds of the time that -O3 takes: it is there to test against, in short runs.
compile_lammps() {
  cmake -S "$1/cmake" -B "$1/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DBUILD_SHARED_LIBS=ON -DBUILD_MPI=ON \
    -DBUILD_OMP=OFF -DPKG_PLUGIN=ON -DPKG_GRANULAR=ON
  cmake --build "$1/build" --parallel "$cores"
}

skip_lammps() {
  echo "    going on without the $1 LAMMPS: $2"
  echo "$2" >"$cache/lammps-$1.missing"
}
