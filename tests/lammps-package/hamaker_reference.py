# SPDX-License-Identifier: BSD-3-Clause
"""The Hamaker law as the manual page states it, written down again for the tests."""


def force(gap, reduced, A, cut, out):
    """Attraction, > 0."""
    if gap >= out:
        return 0.0
    return A * reduced / (6.0 * max(gap, cut) ** 2)


def energy(gap, reduced, A, cut, out):
    if gap >= out:
        return 0.0
    if gap >= cut:
        return A * reduced / 6.0 * (1.0 / out - 1.0 / gap)
    return A * reduced / 6.0 * (1.0 / out - 1.0 / cut - (cut - gap) / cut**2)


def position_tolerance(length, gap, cut):
    """Relative error of a force ~ 1/gap^2 when both sides round the gap, a difference of numbers
    of size `length`, in their own way: 8 roundings of 2^-53 on each side, doubled by the square.
    Below the cut-off the force is constant; there the ordinary rounding of 20 operations is left.
    """
    rounding = 2.0**-53
    if gap < cut:
        return 20.0 * rounding
    return 2.0 * 16.0 * length * rounding / gap + 20.0 * rounding
