// SPDX-License-Identifier: GPL-2.0-or-later
// Registers the cohesion models when this is loaded, before the engine reads its script. The
// factories are made at their first use, so the order of initialisation does not matter.

#include "register_combinations.h"

namespace {

const struct RegisterCohesionModels {
  RegisterCohesionModels() {
    using namespace LIGGGHTS::ContactModels;
    using LIGGGHTS::Cohesion::register_with_each_tangential_model;
    Factory::instance().addCohesionModel("hamaker", COHESION_HAMAKER);
    register_with_each_tangential_model<HOOKE, COHESION_HAMAKER>();
    register_with_each_tangential_model<HOOKE_STIFFNESS, COHESION_HAMAKER>();
    register_with_each_tangential_model<HERTZ, COHESION_HAMAKER>();
    register_with_each_tangential_model<HERTZ_STIFFNESS, COHESION_HAMAKER>();
  }
} at_load;

}  // namespace
