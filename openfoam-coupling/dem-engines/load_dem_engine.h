// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <string_view>

#include "dem_engine.h"

namespace cohesion::coupling {

/// The table of engines: name in the case, library that holds the adapter, and the option of the
/// build that makes it.
struct DemEngineRow {
  std::string_view name;
  std::string_view library;
  std::string_view option;
};

inline constexpr std::array dem_engines{
    DemEngineRow{"lammps", "libcohesionLammpsEngine.so", "COHESION_LAMMPS"},
    DemEngineRow{"liggghts", "libcohesionLiggghtsEngine.so", "COHESION_LIGGGHTS"},
};

/// The engine called `name`. Throws InvalidParameter (validation.h) that lists the valid names.
const DemEngineRow& dem_engine(const std::string& name);

/// The file of an engine's adapter, beside the calling library. Throws DemEngineError, with how to
/// build it, when it is not there.
std::string dem_engine_library(const DemEngineRow& engine);

/// Loads the adapter library, never to unload it: engines leave global state behind.
/// Throws DemEngineError, with the loader's own words, when it cannot be loaded or was built for
/// another version of the interface.
MakeDemEngine load_dem_engine(const std::string& library);

}  // namespace cohesion::coupling
