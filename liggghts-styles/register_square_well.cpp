// SPDX-License-Identifier: GPL-2.0-or-later
#include "register_combinations.h"

static const bool at_load = LIGGGHTS::Cohesion::register_with_each_normal_model<
    LIGGGHTS::ContactModels::COHESION_SQUARE_WELL>("square_well");
