// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_REGISTER_COMBINATIONS_H
#define COHESION_REGISTER_COMBINATIONS_H

// The engine's headers need these three before all others.
#include <mpi.h>
// clang-format off
#include "fix_insert_stream.h"
#include "global_properties.h"
// clang-format on
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

/// A normal model with each tangential model, without rolling friction.
template <int Normal, int CohesionModel>
void register_with_each_tangential_model() {
  using namespace ContactModels;
  register_combination<GranStyle<Normal, TANGENTIAL_OFF, CohesionModel>>();
  register_combination<GranStyle<Normal, TANGENTIAL_NO_HISTORY, CohesionModel>>();
  register_combination<GranStyle<Normal, TANGENTIAL_HISTORY, CohesionModel>>();
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
