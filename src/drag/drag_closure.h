// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "drag/syamlal_obrien.h"

/// The table of drag closures: the one place that knows them all.
/// To add one: its header beside this file, and its row in `closures`.
namespace cohesion::drag {

/// Drag per volume of solid and unit slip, beta/(1 - eps), [mass/(volume time)]; arguments as in
/// SyamlalOBrien::per_solid_volume. The drag on a particle of volume V_p is
/// V_p beta/(1 - eps) (u - v).
using PerSolidVolume = double (*)(double void_fraction, double slip, double diameter,
                                  double density, double viscosity);

struct Closure {
  std::string_view name;
  PerSolidVolume per_solid_volume;
};

inline constexpr std::array closures{
    Closure{SyamlalOBrien::name, &SyamlalOBrien::per_solid_volume},
};

}  // namespace cohesion::drag
