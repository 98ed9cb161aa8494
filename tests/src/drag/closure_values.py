#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints closure_values.h: every drag closure at 20 points, from closure_formulas.py with 50 digits.
Needs mpmath.

The arguments are the doubles that the test uses, taken as exact. At no slip the formulas divide by
zero; there they are evaluated at 1e-60 m/s, where the terms that vanish with it, the slowest of which
goes with its square root, are below 1e-27.
"""
import mpmath

from cohesion_tests.theory.closure_formulas import CLOSURES

mpmath.mp.dps = 80
DIAMETER, DENSITY, VISCOSITY = 1e-3, 1.205, 1.75e-5
VOID_FRACTIONS = (0.38, 0.55, 0.7, 0.9, 1.0)
SLIPS = (0.0, 2e-3, 0.4, 20.0)

print("""// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Written by closure_values.py beside this file.

// clang-format off
namespace cohesion::drag {
""")
print(f"inline constexpr double value_diameter = {DIAMETER!r};   // [m]")
print(f"inline constexpr double value_density = {DENSITY!r};     // [kg/m3]")
print(f"inline constexpr double value_viscosity = {VISCOSITY!r}; // [Pa s]")
print("""
/// beta/(1 - eps) [kg/(m3 s)] of a closure at a void fraction and a slip [m/s].
struct ClosureValue {
  const char* closure;
  double void_fraction, slip, value;
};

inline constexpr ClosureValue closure_values[] = {""")
for name, closure in CLOSURES.items():
    for eps in VOID_FRACTIONS:
        for slip in SLIPS:
            value = closure(mpmath, *(mpmath.mpf(x) for x in (
                eps, slip or mpmath.mpf("1e-60"), DIAMETER, DENSITY, VISCOSITY)))
            print(f'    {{"{name}", {eps!r}, {slip!r}, {mpmath.nstr(value, 25)}}},')
print("""};

}  // namespace cohesion::drag
// clang-format on""")
