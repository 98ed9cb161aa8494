// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "dem_engine.h"

namespace cohesion::coupling {

/// The table of engines: name in the case, library that holds the adapter.
struct DemEngineLibrary {
  std::string_view name;
  std::string_view library;
};

inline constexpr std::array dem_engine_libraries{
    DemEngineLibrary{"lammps", "libcohesionLammpsEngine.so"},
};

/// Where the adapter of the engine called `name` lies: beside the calling library, unless `library`
/// names a file. Throws InvalidParameter (validation.h) that lists the valid names.
std::string dem_engine_library(const std::string& name, const std::string& library = "");

/// Loads the adapter library, never to unload it: engines leave global state behind.
/// Throws DemEngineError, with the loader's own words, when it cannot be loaded or was built for
/// another version of the interface.
MakeDemEngine load_dem_engine(const std::string& library);

}  // namespace cohesion::coupling
