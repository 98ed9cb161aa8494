# SPDX-License-Identifier: BSD-3-Clause
"""The Hamaker law as the manual page states it, written down again for the tests."""
import decimal
import math

# The exact form is written in the distance of the centres: of the digits that this costs, twelve a
# power of s - 4 at the smallest gaps, plenty are left.
DIGITS = decimal.Context(prec=80)


def small_gap(gap, ri, rj):
    """Attraction and energy per A/6; rj = inf is a plane."""
    reduced = 1 / (1 / ri + 1 / rj)
    return reduced / gap**2, -reduced / gap


def exact(gap, ri, rj):
    with decimal.localcontext(DIGITS):
        h, r = decimal.Decimal(gap), decimal.Decimal(ri)
        if math.isinf(rj):
            force = 4 * r**3 / (h * (h + 2 * r)) ** 2
            energy = -(r / h + r / (h + 2 * r) + (h / (h + 2 * r)).ln())
        else:
            other = decimal.Decimal(rj)
            distance = r + other + h
            s = (distance**2 - (r - other) ** 2) / (r * other)
            slope = 2 * distance / (r * other)
            force = slope * (2 / (s - 4) ** 2 + 2 / s**2 - 1 / (s - 4) + 1 / s)
            energy = -(2 / (s - 4) + 2 / s + ((s - 4) / s).ln())
        return float(force), float(energy)


FORMS = {"small_gap": small_gap, "exact": exact}


def cap(asperity):
    """Radius and height of an asperity: of Rumpf's hemisphere, given by its radius, or of Rabinovich's cap, given by
    (rms, wavelength) of the surface."""
    if not isinstance(asperity, tuple):
        return asperity, asperity
    rms, wavelength = asperity
    return wavelength**2 / (32 * 1.817 * rms), 1.817 * rms


def rough(form, gap, ri, rj, asperity):
    """With an asperity between the surfaces, as cap() takes it; 0 for none."""
    radius, height = cap(asperity)
    force, energy = FORMS[form](gap + height, ri, rj)
    if radius > 0:
        tip = FORMS[form](gap, radius, 1 / (1 / ri + 1 / rj))
        force, energy = force + tip[0], energy + tip[1]
    return force, energy


def force(form, gap, ri, rj, A, cut, out, asperity=0.0):
    """Attraction, > 0."""
    if gap >= out:
        return 0.0
    return A / 6.0 * rough(form, max(gap, cut), ri, rj, asperity)[0]


def energy(form, gap, ri, rj, A, cut, out, asperity=0.0):
    if gap >= out:
        return 0.0
    pull, depth = rough(form, max(gap, cut), ri, rj, asperity)
    shift = rough(form, out, ri, rj, asperity)[1]
    return A / 6.0 * (depth - shift - pull * max(cut - gap, 0.0))


def words(A, cut, out, asperity=0.0):
    """The parameters as a script gives them."""
    given = f"hamaker {A:.17g} cutoff {cut:.17g} {out:.17g}"
    if isinstance(asperity, tuple):
        return given + " roughness {:.17g} {:.17g}".format(*asperity)
    return given + (f" asperity {asperity:.17g}" if asperity else "")


def position_tolerance(length, gap, cut):
    """Relative error of a force ~ 1/gap^2 when both sides round the gap, a difference of numbers
    of size `length`, in their own way: 8 roundings of 2^-53 on each side, doubled by the square;
    and seven times that beyond 1e-6, where the exact force may fall as 1/gap^7. Below the cut-off
    the force is constant; there the ordinary rounding of 20 operations is left.
    """
    rounding = 2.0**-53
    if gap < cut:
        return 20.0 * rounding
    power = 2.0 if gap < 1e-6 else 7.0
    return power * 16.0 * length * rounding / gap + 20.0 * rounding
