# SPDX-License-Identifier: BSD-3-Clause
"""Which runs the shear example makes."""

import math
from collections import namedtuple

# 1 of the thesis's D* = D/(rho_s rate^2 (2 r)^5), at its L = rho_s = 1, in m rate^2 r^2.
STARRED = 32 / (120 * math.pi)


class Run(namedtuple("Run", "phi D w e")):
    """Area fraction, depth D/(m rate^2 r^2), r_out/r, restitution."""

    @property
    def name(self):
        return f"phi{self.phi:.4f}-D{self.D:g}-w{self.w:g}-e{self.e:g}"


def starred(phi, depth, w=1.001, e=0.9):
    """Run of the depth D* of the thesis, at its width and restitution."""
    return Run(phi, STARRED * depth, w, e)


# Collisions per particle before the first block and in a block, blocks at most, seed of the start, side
# of the box in radii (120: the thesis's 458 to 2292 discs; 85: half as many).
Rule = namedtuple("Rule", "start block most seed side")
THESIS = Rule(2500, 500, 40, 1, 120)
SHORT = Rule(800, 200, 6, 1, 85)

FRACTIONS = (0.1, 0.2, 0.3, 0.4, 0.5)
WIDTH, RESTITUTION = 1.1, 0.9
MILD = (0, 1, 2, 4)  # depths below the transition; 4 begins to form clusters at 0.4
WIDTHS, AT_WIDTHS, WIDTHS_DEPTH = (1.001, 1.01, 1.1), (0.2, 0.4), 2
# Depths at which the transition is looked for, and where it is looked for more closely.
TRANSITION = {8: (0.25, 0.2625, 0.275, 0.2875, 0.35), 16: (0.125, 0.15, 0.1625, 0.175)}


def subset():
    runs = [Run(phi, D, WIDTH, RESTITUTION) for D in (*MILD, *TRANSITION) for phi in FRACTIONS]
    runs += [Run(phi, D, WIDTH, RESTITUTION) for D, more in TRANSITION.items() for phi in more]
    runs += [Run(phi, WIDTHS_DEPTH, w, RESTITUTION) for w in WIDTHS for phi in AT_WIDTHS]
    return list(dict.fromkeys(runs))


def full():
    fractions = [0.05 * k for k in range(2, 11)]
    runs = [Run(round(phi, 3), D, w, e) for e in (0.8, 0.9) for D in (0, 1, 2, 4, 8, 12, 16, 24)
            for w in ((WIDTH,) if D == 0 else (1.0001, 1.001, 1.01, 1.05, 1.1)) for phi in fractions]
    return list(dict.fromkeys(subset() + runs))


# The thesis's own parameters: depths D* at their fractions, widths at D* 10, and their block rule with fewer blocks.
LIMITED = THESIS._replace(most=6)
TEN, TEN_AT, TEN_WIDTHS = 10, (0.1, 0.3, 0.5), (1.0001, 1.001, 1.01, 1.1)
DEPTHS = {0: FRACTIONS, 5: TEN_AT, 15: FRACTIONS}
RECORDED = Rule(150, 50, 4, 1, 120)  # short runs at D* 10 that record every event


def thesis():
    """Runs of the thesis's parameters below the depths at which agglomerates grow, and their rule."""
    runs = [starred(phi, depth) for depth, fractions in DEPTHS.items() for phi in fractions]
    return [(run, LIMITED) for run in runs + [starred(phi, TEN, w) for w in TEN_WIDTHS for phi in TEN_AT]]


def recorded():
    return [(starred(phi, TEN, w), RECORDED) for w in TEN_WIDTHS for phi in TEN_AT]
