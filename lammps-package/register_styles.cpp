// SPDX-License-Identifier: GPL-2.0-only
// Names every style of the package to the engine; called by plugin.cpp when the version is right.

#include "compute_gran_energy.h"
#include "compute_hard_events.h"
#include "fix_event_step.h"
#include "fix_gas_coupling.h"
#include "fix_hard_events.h"
#include "fix_wall_gran_hamaker.h"
#include "fix_wall_gran_square_well.h"
#include "fix_wall_hamaker.h"
#include "fix_wall_hard_square_well.h"
#include "lammps.h"
#include "lammpsplugin.h"
#include "pair_gran_hamaker.h"
#include "pair_gran_square_well.h"
#include "pair_hamaker.h"
#include "pair_hard_square_well.h"
#include "pair_square_well.h"
#include "version.h"

using namespace LAMMPS_NS;

namespace {

template <class Style>
void* make_pair_style(void* lmp) {
  return new Style(static_cast<LAMMPS*>(lmp));
}

template <class Style>
void* make_fix_style(void* lmp, int narg, char** arg) {
  return new Style(static_cast<LAMMPS*>(lmp), narg, arg);
}

template <class Style>
void* make_compute_style(void* lmp, int narg, char** arg) {
  return new Style(static_cast<LAMMPS*>(lmp), narg, arg);
}

}  // namespace

extern "C" void cohesion_register_styles(void* lmp, void* handle, void* regfunc) {
  const auto register_style = reinterpret_cast<lammpsplugin_regfunc>(regfunc);
  lammpsplugin_t plugin{};
  plugin.version = LAMMPS_VERSION;
  plugin.author = "the COHESION package";
  plugin.handle = handle;

  plugin.style = "pair";
  plugin.name = "hamaker";
  plugin.info = "pair hamaker";
  plugin.creator.v1 = &make_pair_style<PairHamaker>;
  register_style(&plugin, lmp);

  plugin.name = "gran/hamaker";
  plugin.info = "pair gran/hamaker";
  plugin.creator.v1 = &make_pair_style<PairGranHamaker>;
  register_style(&plugin, lmp);

  plugin.name = "gran/square_well";
  plugin.info = "pair gran/square_well";
  plugin.creator.v1 = &make_pair_style<PairGranSquareWell>;
  register_style(&plugin, lmp);

  plugin.name = "square_well";
  plugin.info = "pair square_well";
  plugin.creator.v1 = &make_pair_style<PairSquareWell>;
  register_style(&plugin, lmp);

  plugin.name = "hard/square_well";
  plugin.info = "pair hard/square_well";
  plugin.creator.v1 = &make_pair_style<PairHardSquareWell>;
  register_style(&plugin, lmp);

  plugin.style = "fix";
  plugin.name = "HARD_EVENTS";
  plugin.info = "fix HARD_EVENTS";
  plugin.creator.v2 = &make_fix_style<FixHardEvents>;
  register_style(&plugin, lmp);

  plugin.name = "EVENT_STEP";
  plugin.info = "fix EVENT_STEP";
  plugin.creator.v2 = &make_fix_style<FixEventStep>;
  register_style(&plugin, lmp);

  plugin.name = "wall/hamaker";
  plugin.info = "fix wall/hamaker";
  plugin.creator.v2 = &make_fix_style<FixWallHamaker>;
  register_style(&plugin, lmp);

  plugin.name = "wall/gran/hamaker";
  plugin.info = "fix wall/gran/hamaker";
  plugin.creator.v2 = &make_fix_style<FixWallGranHamaker>;
  register_style(&plugin, lmp);

  plugin.name = "wall/gran/square_well";
  plugin.info = "fix wall/gran/square_well";
  plugin.creator.v2 = &make_fix_style<FixWallGranSquareWell>;
  register_style(&plugin, lmp);

  plugin.name = "wall/hard/square_well";
  plugin.info = "fix wall/hard/square_well";
  plugin.creator.v2 = &make_fix_style<FixWallHardSquareWell>;
  register_style(&plugin, lmp);

  plugin.name = "gas/coupling";
  plugin.info = "fix gas/coupling";
  plugin.creator.v2 = &make_fix_style<FixGasCoupling>;
  register_style(&plugin, lmp);

  plugin.style = "compute";
  plugin.name = "gran/energy";
  plugin.info = "compute gran/energy";
  plugin.creator.v2 = &make_compute_style<ComputeGranEnergy>;
  register_style(&plugin, lmp);

  plugin.name = "hard/events";
  plugin.info = "compute hard/events";
  plugin.creator.v2 = &make_compute_style<ComputeHardEvents>;
  register_style(&plugin, lmp);
}
