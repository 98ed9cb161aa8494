# SPDX-License-Identifier: BSD-3-Clause
"""Rise velocities and sizes of measured bubbles beside the correlations. Lengths in m, velocities in m/s."""

import numpy as np

G = 9.81
LARGE = 12  # diameters of a sphere: what is given for bubbles that are larger by itself
THREE_D = 0.711  # v/sqrt(g d) of a lone bubble (Davies and Taylor; what examples/discrete-bubbles takes)
TWO_D = 0.48  # the same in a bed of two dimensions (Pyle and Harrison, Chem. Eng. Sci. 22 (1967) 1199)


def darton(excess, height, plate):
    """Diameter at a height above a plate of 4 sqrt(A_0) = `plate` (Darton et al., Trans. IChemE 55 (1977) 274; for three
    dimensions); excess: u - u_mf."""
    return 0.54 * excess**0.4 * (height + plate)**0.8 / G**0.2


def mean_and_error(values):
    """Mean, and its standard error as of independent values."""
    values = np.asarray(values, float)
    return float(values.mean()), float(values.std(ddof=1) / np.sqrt(len(values))) if len(values) > 1 else np.nan


def figures(lives, velocity, minimum, plate, sphere):
    """{name: (mean, standard error)} of the bubbles `lives`, (diameter, height, rise velocity, ...) of each, and, as
    large_..., of those of LARGE diameters `sphere`; at the gas velocity `velocity` in a bed fluidised at `minimum`."""
    large = of_bubbles([life for life in lives if life[0] >= LARGE * sphere], velocity, minimum, plate)
    return {**of_bubbles(lives, velocity, minimum, plate),
            **{f"large_{name}": large[name] for name in ("bubbles", "diameter", "rise_over_root", "over_3d", "over_darton")
               if name in large}}


def of_bubbles(lives, velocity, minimum, plate):
    """Those of figures() without the large ones."""
    if not len(lives):
        return {"bubbles": (0, np.nan)}
    d, h, v = np.asarray(lives, float)[:, :3].T
    root, excess = np.sqrt(G * d), velocity - minimum
    return {"bubbles": (len(d), np.nan), "diameter": mean_and_error(d), "height": mean_and_error(h),
            "rise": mean_and_error(v), "rise_over_root": mean_and_error(v / root),
            "less_excess_over_root": mean_and_error((v - excess) / root),
            "over_3d": mean_and_error(v / (THREE_D * root)), "over_isolated": mean_and_error(v / (TWO_D * root)),
            "over_excess": mean_and_error(v / (excess + TWO_D * root)),
            "over_darton": mean_and_error(d / darton(excess, h, plate))}
