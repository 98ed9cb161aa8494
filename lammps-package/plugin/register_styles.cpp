// SPDX-License-Identifier: GPL-2.0-only
// Names every style of the package to the engine; called by plugin.cpp when the version is right.

#include <string>
#include <string_view>

#include "attraction/fix_wall_hamaker.h"
#include "attraction/pair_hamaker.h"
#include "bubbles/fix_bubbles.h"
#include "cohesion_version.h"
#include "common/compute_shear_profile.h"
#include "common/engine_api.h"
#include "common/fix_agglomerates.h"
#include "common/fix_deform_shear.h"
#include "common/fix_drive.h"
#include "common/fix_gas_coupling.h"
#include "contact_step/fix_contact_step.h"
#include "hard_spheres/fix_hard_events.h"
#include "hard_spheres/fix_wall_hard_square_well.h"
#include "hard_spheres/pair_hard_square_well.h"
#include "lammps.h"
#include "lammpsplugin.h"
#include "outputs/compute_gran_energy.h"
#include "outputs/compute_gran_stress.h"
#include "outputs/compute_hard_events.h"
#include "outputs/compute_hard_stress.h"
#include "outputs/fix_stationary.h"
#include "soft_contacts/fix_contact_history.h"
#include "soft_contacts/fix_wall_gran_styles.h"
#include "soft_contacts/pair_gran_styles.h"
#include "version.h"

using namespace LAMMPS_NS;

namespace {

template <class Style>
void* make_pair(void* lmp) {
  return new Style(static_cast<LAMMPS*>(lmp));
}

/// A fix or a compute.
template <class Style>
void* make(void* lmp, int narg, char** arg) {
  return new Style(static_cast<LAMMPS*>(lmp), narg, arg);
}

struct PairRow {
  const char* name;
  lammpsplugin_factory1* factory;
};

#define COHESION_SAME_NAME(style, Law) static_assert(std::string_view(Law::STYLE) == #style);
COHESION_PAIR_LAWS(COHESION_SAME_NAME)

constexpr PairRow pairs[] = {
#define PAIR_CLASS
#define PairStyle(name, Style) {#name, &make_pair<Style>},
#include "soft_contacts/pair_gran_styles.h"
#undef PAIR_CLASS
    {"hamaker", &make_pair<PairHamaker>},
    {"hard/squarewell", &make_pair<PairHardSquareWell>},
    {"hard/square_well", &make_pair<FormerPairHardSquareWell>},
};

struct StyleEntry {
  const char* name;
  lammpsplugin_factory2* factory;
};

constexpr StyleEntry fixes[] = {
    {"CONTACT_HISTORY", &make<FixContactHistory>},
    {"CONTACT_STEP", &make<FixContactStep>},
    {"HARD_EVENTS", &make<FixHardEvents>},
    {"agglomerates", &make<FixAgglomerates>},
    {"bubbles", &make<FixBubbles>},
    {"deform/shear", &make<FixDeformShear>},
    {"drive", &make<FixDrive>},
    {"gas/coupling", &make<FixGasCoupling>},
    {"stationary", &make<FixStationary>},
#define FIX_CLASS
#define FixStyle(name, Style) {#name, &make<Style>},
#include "soft_contacts/fix_wall_gran_styles.h"
#undef FIX_CLASS
    {"wall/hamaker", &make<FixWallHamaker>},
    {"wall/hard/squarewell", &make<FixWallHardSquareWell>},
    {"wall/hard/square_well", &make<FormerFixWallHardSquareWell>},
};

constexpr StyleEntry computes[] = {
    {"gran/energy", &make<ComputeGranEnergy>},     {"gran/stress", &make<ComputeGranStress>},
    {"hard/events", &make<ComputeHardEvents>},     {"hard/stress", &make<ComputeHardStress>},
    {"shear/profile", &make<ComputeShearProfile>},
};

}  // namespace

extern "C" void cohesion_register_styles(void* lmp, void* handle, void* regfunc) {
  const auto register_style = reinterpret_cast<lammpsplugin_regfunc>(regfunc);
  lammpsplugin_t plugin{};
  plugin.version = LAMMPS_VERSION;
  plugin.author = "the COHESION package";
  plugin.handle = handle;

  plugin.style = "pair";
  for (const PairRow& row : pairs) {
    plugin.name = plugin.info = row.name;
    plugin.creator.v1 = row.factory;
    register_style(&plugin, lmp);
  }
  const auto register_all = [&](const char* kind, const auto& rows) {
    plugin.style = kind;
    for (const StyleEntry& row : rows) {
      plugin.name = plugin.info = row.name;
      plugin.creator.v2 = row.factory;
      register_style(&plugin, lmp);
    }
  };
  register_all("fix", fixes);
  register_all("compute", computes);

  engine_api::tell(static_cast<LAMMPS*>(lmp),
                   "Cohesion " COHESION_VERSION ", built for LAMMPS " LAMMPS_VERSION "\n");
}
