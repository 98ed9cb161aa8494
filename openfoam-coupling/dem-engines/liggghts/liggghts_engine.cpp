// SPDX-License-Identifier: GPL-2.0-or-later
#include "../lammps_family_engine.h"

#include "write_restart.h"

namespace {

/// What contacts remember is stored by particle when the list of neighbours is made, and here.
void write_state(LAMMPS_NS::LAMMPS* liggghts, const std::string& file) {
  const auto* modify = liggghts->modify;
  for (int k = 0; k < modify->nfix; k++)
    if (std::string(modify->fix[k]->style) == "contacthistory") modify->fix[k]->pre_exchange();
  std::string name = file;
  LAMMPS_NS::WriteRestart(liggghts).write(name.data());
}

}  // namespace

extern "C" {

int cohesion_dem_engine_interface() { return cohesion::coupling::dem_engine_interface; }

/// LIGGGHTS as particle engine, with the styles of liggghts-styles. Its command `if` compares
/// numbers only.
cohesion::coupling::DemEngine* cohesion_make_dem_engine(
    const cohesion::coupling::DemEngineSettings& settings) {
  return new cohesion::coupling::LammpsFamilyEngine(
      settings,
      {"LIGGGHTS", "1", "0", "LIGGGHTS ends a run early when a signal asks it to.", write_state});
}
}
