// SPDX-License-Identifier: GPL-2.0-or-later
#include "../lammps_family_engine.h"

namespace {

/// A run ends with what contacts remember stored by particle.
void write_state(LAMMPS_NS::LAMMPS* lammps, const std::string& file) {
  lammps->input->one(("write_restart " + file + " noinit").c_str());
}

}  // namespace

extern "C" {

int cohesion_dem_engine_interface() { return cohesion::coupling::dem_engine_interface; }

/// LAMMPS as particle engine; the script loads the package's plugin.
cohesion::coupling::DemEngine* cohesion_make_dem_engine(
    const cohesion::coupling::DemEngineSettings& settings) {
  return new cohesion::coupling::LammpsFamilyEngine(
      settings, {"LAMMPS", "yes", "no",
                 "Typical causes are 'fix halt' with 'error soft' or 'error continue', and 'timer "
                 "timeout': remove them from the script; 'endTime' and 'stopAt' in "
                 "system/controlDict end the run.",
                 write_state});
}
}
