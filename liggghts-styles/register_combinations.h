// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_REGISTER_COMBINATIONS_H
#define COHESION_REGISTER_COMBINATIONS_H

// The engine's headers need these three before all others.
#include <mpi.h>
// clang-format off
#include "fix_insert_stream.h"
#include "global_properties.h"
// clang-format on
#include "cohesive_pairs.h"
#include "contact_models.h"
#include "fix_wall_gran_base.h"
#include "pair_gran_base.h"

namespace LIGGGHTS {
namespace Cohesion {

/// Makes one combination of contact models known to pair_style gran and fix wall/gran.
template <class Style>
void register_combination() {
  using Model = ContactModels::ContactModel<Style>;
  PairStyles::Factory::instance().addStyle(
      "gran", Style::HASHCODE,
      [](LAMMPS* lmp, PairGran* pair, int64_t hash) -> PairStyles::IGranularPairStyle* {
        return new PairStyles::Granular<Model>(lmp, pair, hash);
      });
  Walls::Factory::instance().addStyle(
      "gran", Style::HASHCODE,
      [](LAMMPS* lmp, FixWallGran* wall, int64_t hash) -> Walls::IGranularWall* {
        return new Walls::Granular<Model>(lmp, wall, hash);
      });
}

template <int CohesionModel, int Normal, int Tangential>
void register_with_each_rolling_model() {
  using namespace ContactModels;
  register_combination<GranStyle<Normal, Tangential, CohesionModel, ROLLING_OFF>>();
  register_combination<GranStyle<Normal, Tangential, CohesionModel, ROLLING_CDT>>();
  register_combination<GranStyle<Normal, Tangential, CohesionModel, ROLLING_EPSD2>>();
}

template <int CohesionModel, int Normal>
void register_with_each_tangential_model() {
  using namespace ContactModels;
  register_with_each_rolling_model<CohesionModel, Normal, TANGENTIAL_OFF>();
  register_with_each_rolling_model<CohesionModel, Normal, TANGENTIAL_NO_HISTORY>();
  register_with_each_rolling_model<CohesionModel, Normal, TANGENTIAL_HISTORY>();
}

/// Makes a cohesion model known, with each combination of the other models in model-lists/. Call it
/// from a static initialiser, before the engine reads its script: the factories are made at their
/// first use, so the order of initialisation does not matter.
template <int CohesionModel>
bool register_with_each_normal_model(const char* name) {
  using namespace ContactModels;
  Factory::instance().addCohesionModel(name, CohesionModel);
  note_cohesion_model(name);
  register_with_each_tangential_model<CohesionModel, HOOKE>();
  register_with_each_tangential_model<CohesionModel, HOOKE_STIFFNESS>();
  register_with_each_tangential_model<CohesionModel, HERTZ>();
  register_with_each_tangential_model<CohesionModel, HERTZ_STIFFNESS>();
  return true;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
