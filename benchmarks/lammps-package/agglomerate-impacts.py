#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Many contacts with the exact scheme in LAMMPS at coarse steps against a fine one: impacts of agglomerates, a cluster
that oscillates, and the escape of a sphere from a bound pair.

  agglomerate-impacts.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--steps N ...] [--finest N] [--csv FILE]

Spheres of 1 mm, K = 800 N/m, A = 2e-18 J, by steps in the contact time t_c of the undamped spring. Scenes:
bound_clusters.py. "stopped": the step is beyond the stability limit (docs/theory/contact_steps.md).

Impacts: two agglomerates of 43 spheres in random orientation, restitution 0.9, 30 t_c, six for each speed. Columns:
bonds that are different at the end, over the number of bonds; root mean square of the error of the velocities over the
speed of the impact; kinetic energy without spins that is left, over that of the start.
Oscillation: 79 bound spheres with random velocities of 1 mm/s, 20 t_c; root mean square of the error of the velocities
over that of the velocities at the start.
Escape: a sphere strikes one of two that stick, head-on; the second is behind at an angle. Speed above which the sphere
parts, over the same at the finest step: smallest and largest of eight phases.
"""
import numpy

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import bound_clusters as clusters
from cohesion_tests.progress import Progress

SPHERES, RINGING = 43, 79
SPEEDS, OFFSETS, EACH = (0.03, 0.1, 0.3), (0.0, 2.0), 3
ANGLES, PHASES = (45.0, 60.0, 75.0, 90.0, 105.0), 8
RESTITUTION, FRICTIONS = 0.9, (0.0, 0.3)
ROUNDS = 11  # of bisection, from SLOWEST to FASTEST [m/s]
SLOWEST, FASTEST = 0.002, 0.1
STOPPED = "several contacts unstable"


def run(*words):
    """clusters.run(), None where the step is beyond the stability limit."""
    try:
        return clusters.run(*words)
    except RuntimeError as error:
        if STOPPED not in str(error):
            raise
        return None


def root_mean_square(vectors):
    return float(numpy.sqrt((vectors**2).sum(axis=-1).mean()))


def impacts(folder, divisions, friction):
    """Rows of speed, step and columns."""
    random = numpy.random.default_rng(1)
    clusters.write(folder, [clusters.impact(SPHERES, speed, offset, random)
                            for speed in SPEEDS for offset in OFFSETS for _ in range(EACH)])
    known = None
    for division in divisions:
        ended = run(folder, division, 30 * clusters.T_C, RESTITUTION, friction)
        if ended is None:
            yield division, None
            continue
        bonds = clusters.bound(ended[0], 2 * SPHERES).reshape(len(SPEEDS), -1)
        velocities = ended[1].reshape(len(SPEEDS), -1, 3)
        known = known or (bonds, velocities)
        yield division, [(((bonds[k] != known[0][k]).sum() / known[0][k].sum()),
                          root_mean_square(velocities[k] - known[1][k]) / speed,
                          (velocities[k]**2).sum(axis=-1).mean() / (speed / 2)**2) for k, speed in enumerate(SPEEDS)]


def enter(file, friction, division, cells, finest):
    """Impacts into contacts.csv; at the finest step, which others are compared with, only the energy."""
    names = ("bonds that differ", "error of velocities", "final over initial kinetic energy")
    for speed, values in zip(SPEEDS, cells):
        row = {"measurement": "impact of agglomerates", "case": f"friction {friction:g}, {speed:g} m/s",
               "step": f"t_c/{division:g}"}
        for name, value in list(zip(names, values))[2 if finest else 0:]:
            csv_table.enter(file, {**row, "quantity": name}, value=f"{value:.3f}" if value else "0")


def enter_one(file, measurement, case, division, quantity, value):
    csv_table.enter(file, {"measurement": measurement, "case": case, "step": f"t_c/{division:g}", "quantity": quantity},
                    value=value)


def enter_escape(file, division, finest, angle, known, low, high):
    """At the finest step the velocity, at others the range over it."""
    values = {"escape velocity [m/s]": f"{known:.4f}"} if division == finest else {
        f"smallest escape velocity over that at t_c/{finest:g}": f"{low:.3f}",
        f"largest escape velocity over that at t_c/{finest:g}": f"{high:.3f}"}
    for quantity, value in values.items():
        enter_one(file, "sphere against two bound spheres", f"{angle:g} degrees", division, quantity, value)


def ringing(folder, divisions, restitution):
    random = numpy.random.default_rng(2)
    clusters.write(folder, [clusters.ringing(RINGING, 1e-3, random)])
    known = None
    for division in divisions:
        velocities = run(folder, division, 20 * clusters.T_C, restitution)[1]
        known = velocities if known is None else known
        yield division, root_mean_square(velocities - known) / 1e-3 / 3**0.5


def escape(folder, division):
    """Speed above which the sphere parts, by angle and phase."""
    cases = [(angle, phase) for angle in ANGLES for phase in range(PHASES)]
    low, high = numpy.full(len(cases), SLOWEST), numpy.full(len(cases), FASTEST)
    for _ in range(ROUNDS):
        speeds = 0.5 * (low + high)
        clusters.write(folder, [clusters.struck(speed, *case) for speed, case in zip(speeds, cases)])
        places = clusters.run(folder, division, 6 * clusters.T_C, RESTITUTION)[0]
        parted = ~clusters.bound(places, 3)[:, 0, 2]
        low, high = numpy.where(parted, low, speeds), numpy.where(parted, speeds, high)
    return (0.5 * (low + high)).reshape(len(ANGLES), PHASES)


def main():
    words = measuring_program.words(
        __doc__, ("--steps", {"type": float, "nargs": "+", "default": [5, 10, 20, 50], "metavar": "N"}),
        ("--finest", {"type": float, "default": 100, "metavar": "N", "help": "steps that others are compared with"}),
        csv_table.OPTION)
    divisions = [words.finest, *sorted(words.steps, reverse=True)]
    progress = Progress(sum(divisions) * (len(FRICTIONS) + 1))
    with engine.temporary_folder() as folder:
        for friction in FRICTIONS:
            print(f"\rimpacts, friction {friction:g}" + "".join(f"{f'{speed:g} m/s':>28s}" for speed in SPEEDS))
            for division, cells in impacts(folder, divisions, friction):
                progress.add(division)
                print(f"\r  t_c/{division:<18g}" + ("stopped" if cells is None else "".join(
                    f"{bonds:12.3f}{error:8.3f}{energy:8.4f}" for bonds, error, energy in cells)), flush=True)
                enter(words.csv, friction, division, cells or [], division == words.finest)
        for restitution in (1.0, RESTITUTION):
            print(f"oscillation, restitution {restitution:g}")
            for division, error in ringing(folder, divisions, restitution):
                print(f"  t_c/{division:<18g}{error:12.2g}", flush=True)
                if error:
                    enter_one(words.csv, f"cluster of {RINGING} spheres", f"restitution {restitution:g}", division,
                              "error of velocities after 20 t_c", f"{error:#.2g}")
        print("escape" + "".join(f"{f'{angle:g} degrees':>24s}" for angle in ANGLES))
        known = None
        for division in divisions:
            speeds = escape(folder, division)
            known = speeds.mean(axis=1) if known is None else known
            progress.add(division)
            ranges = list(zip(ANGLES, known, speeds.min(axis=1) / known, speeds.max(axis=1) / known))
            print(f"\r  t_c/{division:<8g}" + "".join(f"{low:16.3f}{high:8.3f}" for *_, low, high in ranges), flush=True)
            for escaped in ranges:
                enter_escape(words.csv, division, words.finest, *escaped)
        print("  [m/s]" + "".join(f"{speed:24.5f}" for speed in known))


if __name__ == "__main__":
    main()
