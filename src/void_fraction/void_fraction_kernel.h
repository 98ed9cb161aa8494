// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "void_fraction/particle_centre.h"

/// The table of void-fraction kernels: the one place that knows them all.
/// To add one: its header beside this file, and its row in `kernels`.
namespace cohesion::void_fraction {

/// Adds a particle's volume to the solid volume of cells; arguments as in ParticleCentre::deposit.
using Deposit = void (*)(int cell, double volume, std::vector<double>& solid);

struct Kernel {
  std::string_view name;
  Deposit deposit;
};

inline constexpr std::array kernels{
    Kernel{ParticleCentre::name, &ParticleCentre::deposit},
};

}  // namespace cohesion::void_fraction
