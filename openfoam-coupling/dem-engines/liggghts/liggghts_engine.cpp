// SPDX-License-Identifier: GPL-2.0-or-later
#include "../lammps_family_engine.h"

extern "C" {

int cohesion_dem_engine_interface() { return cohesion::coupling::dem_engine_interface; }

/// LIGGGHTS as particle engine, with the styles of liggghts-styles. Its command `if` compares
/// numbers only.
cohesion::coupling::DemEngine* cohesion_make_dem_engine(
    const cohesion::coupling::DemEngineSettings& settings) {
  return new cohesion::coupling::LammpsFamilyEngine(settings, {"LIGGGHTS", "1", "0"});
}
}
