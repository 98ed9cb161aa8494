#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Prints exact_values.h: attraction and energy of two full spheres, and of a sphere and a
half-space, per A/6, to 50 digits. Needs mpmath.

The energy is the closed form of H. C. Hamaker (1937) in the distance of the centres, evaluated with
150 digits so that its cancellations cost nothing; each value is first compared with the integral of
the attraction 1/r^6 over both bodies, which knows nothing of the closed form. The attraction is the
numerical derivative of the energy. Lengths are the doubles that the test uses, taken as exact.
"""
from mpmath import diff, exp, log, mp, mpf, nstr, quad

mp.dps = 150


def closed_form(ri, rj, gap):
    if rj == 0:  # a plane
        return -(ri / gap + ri / (gap + 2 * ri) + log(gap / (gap + 2 * ri)))
    distance = ri + rj + gap
    s = (distance**2 - (ri - rj) ** 2) / (ri * rj)
    return -(2 / (s - 4) + 2 / s + log((s - 4) / s))


def integral(r, big, gap):
    """Slices of the sphere of radius r at the depth y below its nearest point, each times the
    energy of a point with the other body; y + gap = gap e^t spreads the steep part."""
    def slice_at(t):
        z = gap * exp(t)
        y = z - gap
        if big == 0:
            return z * y * (2 * r - y) / z**3
        distance = r + big + gap
        return (z * 8 * big**3 / distance * (big + z) * y * (2 * r - y) /
                (z * (2 * big + z)) ** 3)
    with mp.workdps(30):
        end = log((gap + 2 * r) / gap)
        return -quad(slice_at, [end * k / 16 for k in range(17)])


print("""// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Written by exact_values.py beside this file.

// clang-format off
namespace cohesion::hamaker {

/// Attraction and energy per A/6 of spheres of radii ri and rj (0: a plane) at a gap; lengths in m.
struct ExactValue {
  double ri, rj, gap, force, energy;
};

inline constexpr ExactValue exact_values[] = {""")
for radii in ((5e-4, 5e-4), (5e-4, 2e-4), (1e-6, 1e-3), (5e-4, 5e5), (5e-4, 0.0)):
    for gap in (1e-10, 4e-10, 1e-7, 1e-5, 1e-4, 3e-4, 1e-3, 2e-2):
        ri, rj, h = (mpf(value) for value in (*radii, gap))
        energy = closed_form(ri, rj, h)
        assert abs(integral(ri, rj, h) / energy - 1) < mpf(10) ** -20, (radii, gap)
        force = diff(lambda x: closed_form(ri, rj, x), h, h=h * mpf(10) ** -60)
        print(f"    {{{radii[0]!r}, {radii[1]!r}, {gap!r},\n     {nstr(force, 50)},\n"
              f"     {nstr(energy, 50)}}},")
print("""};

}  // namespace cohesion::hamaker
// clang-format on""")
