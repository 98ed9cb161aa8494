# SPDX-License-Identifier: BSD-3-Clause
# Fetches engine sources through the machine's own Debian archive, into the cache.
# shellcheck shell=bash disable=SC2154

# Address of the Debian archive that this machine installs from: others may use Debian's code names,
# and a disc has no sources.
archive() {
  # shellcheck disable=SC2016 # apt's own variables
  apt-get indextargets --format '$(REPO_URI) $(LABEL) $(CODENAME) $(COMPONENT)' \
    'Created-By: Packages' 'Origin: Debian' |
    awk -v wanted="Debian $(codename) main" '$1 !~ /^cdrom:/ && $2 " " $3 " " $4 == wanted \
      {print $1; exit}'
}

# fetch_source PACKAGE SUITE FOLDER: the upstream tarball of a source package. apt gets lists and
# state of its own, so that the machine's configuration stays as it is. Signatures are checked.
fetch_source() {
  local package=$1 suite=$2 folder=$3 uri apt listed tarball checksum
  uri=$(archive)
  if [ -z "$uri" ]; then
    # Without lists apt does not know its archives.
    retry logged "$cache/logs/apt-update" "${as_root[@]}" apt-get update || return 1
    uri=$(archive)
  fi
  [ -n "$uri" ] || { echo "no Debian archive in apt's configuration"; return 1; }
  mkdir -p "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial"
  echo "deb-src $uri $suite main" >"$folder/apt/sources.list"
  apt=(apt-get -o "Dir::Etc::sourcelist=$folder/apt/sources.list" -o Dir::Etc::sourceparts=/dev/null
    -o "Dir::State::lists=$folder/apt/lists" -o Dir::State::status=/dev/null
    -o "Dir::Cache=$folder/apt/cache" -o APT::Sandbox::User="$(id -un)")
  retry "${apt[@]}" -o APT::Update::Error-Mode=any update || return 1
  # An archive may lack a small file of a source package and apt then fails: the upstream tarball
  # is enough, if its size and checksum are those of the archive's signed index.
  listed=$("${apt[@]}" --only-source source --print-uris "$package" |
    awk '$2 ~ /\.orig\.tar\.[a-z0-9]+$/ {print $2, $4; exit}')
  read -r tarball checksum <<<"$listed"
  checksum=${checksum#SHA256:}
  [ -n "$checksum" ] || { echo "no source package $package in $suite"; return 1; }
  retry download_tarball || return 1
  rm -rf "$folder/apt"
}

# The rest of fetch_source, with its variables: leaves the checked tarball in the folder.
download_tarball() {
  (cd "$folder" && "${apt[@]}" --only-source source --download-only "$package")
  echo "$checksum  $folder/$tarball" | sha256sum --check
}

upstream_tarball() {
  find "$2" -maxdepth 1 -name "$1_*.orig.tar.*" ! -name '*.asc'
}

codename() {
  # shellcheck disable=SC1091
  (. /etc/os-release && echo "$VERSION_CODENAME")
}

# Upstream version of an installed engine
installed() {
  dpkg-query -W -f='${source:Upstream-Version}' "$1"
}

# fetch_headers PACKAGE VERSION FOLDER: the tarball of just that version. Headers of another one
# would compile and then crash.
fetch_headers() {
  logged "$cache/logs/$1-source" fetch_source "$1" "$(codename)" "$3" || return 1
  [ -e "$3/$1_$2.orig.tar.xz" ] || [ -e "$3/$1_$2.orig.tar.bz2" ] || {
    echo "$1 $2 is installed, but the archive has the source of $(upstream_tarball "$1" "$3")"
    return 1
  }
}

fetch_lammps_headers() {
  local folder=$cache/lammps-stock version
  version=$(installed liblammps0) || return 1
  [ "$(cat "$folder/done" 2>/dev/null)" = "$version" ] && return 0
  rm -rf "$folder" && mkdir -p "$folder"
  fetch_headers lammps "$version" "$folder" || return 1
  tar -xf "$(upstream_tarball lammps "$folder")" -C "$folder" --strip-components=1 \
    --wildcards '*/src/*.h' || return 1
  rm -f "$folder"/lammps_*
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
  local folder=$cache/openfoam-stock version module
  version=$(installed libopenfoam) || return 1
  # Another set of headers may be there, of an earlier version of the package.
  [ "$(cat "$folder/done" 2>/dev/null)" = "$version" ] && [ -d "$folder/lnInclude/turbulence" ] &&
    return 0
  rm -rf "$folder" && mkdir -p "$folder/source"
  fetch_headers openfoam "$version" "$folder" || return 1
  tar -xf "$(upstream_tarball openfoam "$folder")" -C "$folder/source" --strip-components=1 \
    --wildcards '*/src/OpenFOAM' '*/src/OSspecific/POSIX' '*/src/finiteVolume' \
    '*/src/meshTools' '*/src/lagrangian/basic' '*/src/TurbulenceModels' \
    '*/src/transportModels/incompressible' || return 1
  rm -f "$folder"/openfoam_*
  for module in OpenFOAM finiteVolume meshTools; do
    link_headers "$folder/source/src/$module" "$folder/lnInclude/$module"
  done
  link_headers "$folder/source/src/OSspecific/POSIX" "$folder/lnInclude/OSspecific"
  link_headers "$folder/source/src/lagrangian/basic" "$folder/lnInclude/lagrangian"
  for module in turbulenceModels incompressible phaseIncompressible; do
    link_headers "$folder/source/src/TurbulenceModels/$module" "$folder/lnInclude/turbulence"
  done
  echo "${version%%.*}" >"$folder/api"
  echo "$version" >"$folder/done"
}

# Not to be had is no failure: the tests and CMake's summary say so and go on without it.
build_current_lammps() {
  local folder=$cache/lammps-current
  [ -e "$folder/done" ] && return 0
  [ "${COHESION_CURRENT_LAMMPS:-yes}" = yes ] || {
    skip_current_lammps "COHESION_CURRENT_LAMMPS is not 'yes'"
    return 0
  }
  rm -rf "$folder" && mkdir -p "$folder"
  logged "$cache/logs/lammps-current-source" fetch_source lammps trixie "$folder" || {
    skip_current_lammps "its source could not be fetched"
    return 0
  }
  unpack_current_lammps "$folder" || {
    skip_current_lammps "its source could not be unpacked"
    return 0
  }
  logged "$cache/logs/lammps-current-build" compile_current_lammps "$folder" || {
    skip_current_lammps "it could not be built, see $cache/logs/lammps-current-build"
    return 0
  }
  rm -f "$cache/lammps-current.missing"
  touch "$folder/done"
}

unpack_current_lammps() {
  tar -xf "$(upstream_tarball lammps "$1")" -C "$1" --strip-components=1 --exclude='*/doc' \
    --exclude='*/examples' --exclude='*/potentials' --exclude='*/bench' && rm -f "$1"/lammps_*
}

compile_current_lammps() {
  cmake -S "$1/cmake" -B "$1/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON \
    -DBUILD_MPI=ON -DBUILD_OMP=OFF -DPKG_PLUGIN=ON -DPKG_GRANULAR=ON &&
    cmake --build "$1/build" --parallel "$cores"
}

skip_current_lammps() {
  echo "    going on without the current LAMMPS: $1"
  echo "$1" >"$cache/lammps-current.missing"
}
