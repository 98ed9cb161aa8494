# SPDX-License-Identifier: BSD-3-Clause
"""From runs to a law: the hydrodynamic radius of an agglomerate of N spheres by the radius of gyration R_g of their
centres, all radii in those of a sphere,

    R_h = R_s (N/R_s^3)^(c sqrt(R_s/N)),   R_s^2 = 1 + 5/3 R_g^2,

R_s being that of the ball which is filled evenly and has the same radius of gyration, N/R_s^3 the fraction of solid in
it. Exact for one sphere, and R_s of a ball so large that nothing flows through it; N/R_s is the drag that all its spheres
would have alone over that of the ball, which is what keeps the flow out. What agglomerates with neighbours hold: spheres
of that radius among others like them (docs/openfoam-coupling/agglomerate_drag.md)."""

import numpy as np

FITTED = 150  # spheres of the largest agglomerate that the constant is fitted to: larger ones are foretold


def beetstra(phi):
    """F* of slow flow through random arrays: van der Hoef, Beetstra, Kuipers, J. Fluid Mech. 528 (2005) 233, eq. 22."""
    return 10 * phi / (1 - phi)**2 + (1 - phi)**2 * (1 + 1.5 * np.sqrt(phi))


def ball(gyration):
    """R_s."""
    return np.sqrt(1 + 5 / 3 * np.square(gyration))


def radius_by(n, gyration, c):
    """R_h of the law."""
    around = ball(gyration)
    return around * (n / around**3)**(c * np.sqrt(around / n))


def fitted(runs):
    """c of least squares of ln R_h, which it is linear in."""
    n, gyration, radius = (np.array([run[key] for run in runs]) for key in ("n", "gyration", "radius"))
    around = ball(gyration)
    slope = np.log(n / around**3) * np.sqrt(around / n)
    return float(slope @ np.log(radius / around) / (slope @ slope))


def of_body(run, c):
    """Figures of one agglomerate alone; radii in those of a sphere. `over_projected`: its radius over that of the disc
    that is seen along the flow, in the mean of three directions."""
    along, *across = run["radii"]
    return {"n": run["n"], "gyration": run["gyration"], "inside": run["n"] / float(ball(run["gyration"]))**3,
            "radius": run["radius"], "along": along, "across": float(np.mean(across)),
            "over_projected": float(np.mean(np.divide(run["radii"], run["projected"]))),
            "share": run["radius"] / run["n"], "over_law": run["radius"] / float(radius_by(run["n"], run["gyration"], c)),
            "seconds": run["seconds"]}


def of_suspension(run):
    """Share of the closure's drag that agglomerates with neighbours hold, and what the coupling's law makes of it with
    the radius that was measured of one alone. `taken`: fraction of solid of spheres of that radius."""
    alone = run["alone"]
    taken = run["phi"] * alone["radius"]**3 / alone["n"]
    around = alone["radius"] * beetstra(taken) / (1 - taken) if taken < 1 else np.inf
    through = alone["n"] * run["own"] / (1 - run["phi"])
    by_law = float(min(1.0, around / through))
    share = run["F"] / run["own"]
    return {"phi": run["phi"], "taken": taken, "share": share, "share_by_law": by_law, "over_law": share / by_law,
            "seconds": run["seconds"]}


def figures(alone, among):
    """By row: `alone` and `among` are results by name. The row `law` has the constant of those measured alone that have 2
    to FITTED spheres, and how far they are from it."""
    c = fitted([run for run in alone.values() if 1 < run["n"] <= FITTED])
    found = {name: of_body(run, c) for name, run in alone.items()}
    off = np.log([row["over_law"] for row in found.values() if 1 < row["n"] <= FITTED])
    found["law"] = {"c": c, "scatter": float(np.sqrt(np.mean(off**2))), "largest": float(np.exp(np.abs(off).max()) - 1),
                    "of": len(off)}
    return {**found, **{name: of_suspension(run) for name, run in among.items()}}


def text(found):
    """A line for each row."""
    return "\n".join(f"{name:26s}" + "  ".join(f"{key} {value:.4g}" for key, value in row.items())
                     for name, row in found.items())
