// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "drag/beetstra.h"
#include "drag/di_felice.h"
#include "drag/ergun_rowe_henwood.h"
#include "drag/ergun_wen_yu.h"
#include "drag/hill_koch_ladd.h"
#include "drag/syamlal_obrien.h"
#include "drag/tang.h"
#include "drag/tenneti.h"
#include "drag/validity.h"
#include "drag/wen_yu.h"

/// The table of drag closures, or drag laws as users call them: the one place that knows them all.
/// How to add one: CONTRIBUTING.md.
namespace cohesion::drag {

/// Drag per volume of solid and unit slip, beta/(1 - eps), [mass/(volume time)]; arguments as in
/// SyamlalOBrien::per_solid_volume. The drag on a particle of volume V_p is
/// V_p beta/(1 - eps) (u - v), beside -V_p grad p (stokes_scaled.h).
using PerSolidVolume = double (*)(double void_fraction, double slip, double diameter,
                                  double density, double viscosity);

/// The same for closures with a free exponent n of the void fraction, as in ErgunWenYu.
using WithExponent = double (*)(double n, double void_fraction, double slip, double diameter,
                                double density, double viscosity);

struct Closure {
  std::string_view name;
  PerSolidVolume per_solid_volume;
  Validity validity;
  WithExponent with_exponent;    ///< none when the closure has no exponent to choose
  std::string_view no_exponent;  ///< why there is none, as a message has it after "as"
};

inline constexpr std::array closures{
    Closure{SyamlalOBrien::name, &SyamlalOBrien::per_solid_volume, SyamlalOBrien::validity, nullptr,
            SyamlalOBrien::no_exponent},
    Closure{ErgunWenYu::name, &ErgunWenYu::per_solid_volume, ErgunWenYu::validity,
            &ErgunWenYu::with_exponent, ""},
    Closure{ErgunRoweHenwood::name, &ErgunRoweHenwood::per_solid_volume, ErgunRoweHenwood::validity,
            &ErgunWenYu::with_exponent, ""},
    Closure{DiFelice::name, &DiFelice::per_solid_volume, DiFelice::validity, nullptr,
            DiFelice::no_exponent},
    Closure{HillKochLadd::name, &HillKochLadd::per_solid_volume, HillKochLadd::validity, nullptr,
            HillKochLadd::no_exponent},
    Closure{Beetstra::name, &Beetstra::per_solid_volume, Beetstra::validity, nullptr,
            Beetstra::no_exponent},
    Closure{Tenneti::name, &Tenneti::per_solid_volume, Tenneti::validity, nullptr,
            Tenneti::no_exponent},
    Closure{Tang::name, &Tang::per_solid_volume, Tang::validity, nullptr, Tang::no_exponent},
    Closure{WenYu::name, &WenYu::per_solid_volume, WenYu::validity, &WenYu::with_exponent, ""},
};

}  // namespace cohesion::drag
