#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speeds over the exact escape velocity at which the bed's spheres part or stick head-on, against the time
step, with what it costs: the tables and the picture of docs/verification/contacts.md. Scene couples of
examples/error-against-run-time compares the schemes at equal run time.

  step-error.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--plot FILE.png] [--csv FILE]
  step-error.py LIGGGHTS_COHESION                                       which has the sampled scheme only

For each step, couples of graded speed approach with the contact at eight positions within the step.
Printed: the slowest couple that parted and the fastest that was captured, over the velocity of an
exact integration (both 1 when the step is fine), and the seconds that LAMMPS took per couple.
Sampled: gran/hooke/history with pair_style hamaker laid over it, in LIGGGHTS hooke/stiffness with cohesion
hamaker; exact: pair_style gran/hamaker.
"""
import numpy

from cohesion_studies.drawing import pyplot, save
from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import bed_couples as couple, couples
from cohesion_tests.theory import pair_motion
from cohesion_tests.thermo import loop_seconds

SAMPLED = (1e-8, 3e-8, 1e-7, 3e-7, 1e-6, 5e-6, 1.125e-5, 2.25e-5)  # [s]; last: the bed's, the thesis's
EXACT = (1e-6, 5e-6, 1.125e-5, 2.25e-5, 4.5e-5)
POSITIONS = 8
FINEST = 1e-4
# Over the exact escape velocity: coarse over a wide range, fine around it
SPEEDS = numpy.unique(numpy.concatenate([
    numpy.geomspace(0.1, 4.0, 60), numpy.linspace(0.98, 1.02, 40),
    *(1 + sign * numpy.array([FINEST, 2e-4, 5e-4]) for sign in (-1, 1))]))
ASKED = 0.01


def run_sampled(atoms, dt, steps):
    with engine.temporary_folder() as folder:
        engine.write_spheres(folder, atoms, [(0.0, length) for length in SIZE], 1)
        output = engine.run("in.head_on", folder, dt=dt, steps=steps, K=couple.STIFFNESS,
                            gamma=couple.DAMPING / couple.MU, A=couple.A, cut=couple.CUT,
                            out=couple.OUT)
        return engine.dump(folder, "end.txt")[:, 1:4].reshape(-1, 2, 3), output


def run_exact(atoms, dt, steps):
    law = pair_motion.Pair(couple.A, couple.CUT, couple.OUT)
    path, output = couples.run(atoms, ["* * " + law.words()], dt, steps, size=SIZE)
    return path[-1, :, :, :3], output


SIZE = (0.066, 0.18, 0.004)
SCHEMES = {"sampled": (run_sampled, SAMPLED), "exact": (run_exact, EXACT)}


def measure(run, dt, exact, duration):
    """Slowest parted and fastest captured over exact, seconds per couple."""
    atoms = []
    for speed in exact * SPEEDS:
        for position in range(POSITIONS):
            gap = pair_motion.OUT * 1.001 + speed * dt * position / POSITIONS
            atoms += couples.couple(len(atoms) // 2, gap, (0.0, speed, 0.0))
    # The approach from up to a step away, and some steps to part, come on top.
    places, output = run(atoms, dt, int(duration / dt * 1.5) + 40)
    gaps = numpy.linalg.norm(places[:, 1] - places[:, 0], axis=1) - pair_motion.DIAMETER
    parted = (gaps >= pair_motion.OUT).reshape(len(SPEEDS), POSITIONS)
    seconds = loop_seconds(output, 0) / len(gaps)
    return (SPEEDS[parted.any(axis=1)].min(initial=numpy.inf),
            SPEEDS[(~parted).any(axis=1)].max(initial=0.0), seconds)


def error(row):
    """How far off a couple of that step may be; FINEST when the grading does not see it."""
    return max(1 - row[1], row[2] - 1, FINEST)


def at_asked_error(rows):
    """The largest step with the asked error, and seconds per couple there, between two rows."""
    good = max((row for row in rows if error(row) <= ASKED), key=lambda row: row[0])
    worse = [row for row in rows if row[0] > good[0]]
    if not worse:
        return good[0], good[3]
    numbers = [numpy.log([row[0], row[3], error(row)]) for row in (good, worse[0])]
    part = (numpy.log(ASKED) - numbers[0][2]) / (numbers[1][2] - numbers[0][2])
    return tuple(numpy.exp(numbers[0][:2] + part * (numbers[1][:2] - numbers[0][:2])))


def plot(tables, file):
    figure, axes = pyplot.subplots(figsize=(6, 4), constrained_layout=True)
    for (name, rows), marker in zip(tables.items(), "os"):
        axes.loglog([row[3] for row in rows], [error(row) for row in rows], marker=marker, label=name)
        for row in rows:
            axes.annotate(f"{row[0]:.3g} s", (row[3], error(row)), fontsize=7, rotation=70,
                          textcoords="offset points", xytext=(2, 5))
    axes.margins(x=0.1, y=0.22)
    axes.axhline(FINEST, color="grey", linewidth=0.8, linestyle=":")
    axes.text(0.98, FINEST * 0.9, "resolution", color="grey", fontsize=7, ha="right", va="top",
              transform=axes.get_yaxis_transform())
    axes.set_xlabel("run time per pair [s]")
    axes.set_ylabel("error of the escape velocity")
    axes.legend(title="scheme, at the time step")
    save(figure, file)


def enter(file, scheme, dt, slowest, fastest):
    """Into contacts.csv."""
    step = f"{dt:.3g} s".replace("e-0", "e-")
    for name, value in (("slowest escape", slowest), ("fastest capture", fastest)):
        csv_table.enter(file, {"measurement": "escape velocity", "case": scheme, "step": step,
                               "quantity": f"{name} over the escape velocity"}, value=f"{value:.4f}")


def main():
    options = measuring_program.words(__doc__, ("--plot", {"metavar": "FILE"}), csv_table.OPTION, liggghts=True)
    if options.csv and not options.plugin:
        raise SystemExit("--csv: of LAMMPS")

    exact = couple.escape_velocity()
    # Long enough for the couple just above the exact velocity to part.
    duration = couple.steps_needed((1 + FINEST) * exact) * couple.DT
    print(f"exact escape velocity {exact:.6g} m/s\n"
          "scheme      dt [s]  slowest parted  fastest captured  seconds per couple")
    tables = {}
    for name, (run, steps) in SCHEMES.items():
        if not options.plugin and name == "exact":
            continue
        tables[name] = []
        for dt in steps:
            row = dt, *measure(run, dt, exact, duration)
            tables[name].append(row)
            print(f"{name:8}{dt:10.3g}  {row[1]:14.4f}  {row[2]:16.4f}  {row[3]:18.2g}", flush=True)
            enter(options.csv, name, *row[:3])
    found = {name: at_asked_error(rows) for name, rows in tables.items()}
    for name, (step, seconds) in found.items():
        print(f"at an error of {ASKED:g}: {name} {step:.2g} s, {seconds:.2g} seconds per couple")
    if len(found) == 2:
        (sampled_step, sampled_time), (exact_step, exact_time) = found.values()
        print(f"exact: {exact_step / sampled_step:.0f} times fewer steps, {sampled_time / exact_time:.0f} "
              "times less time")
    if options.plot:
        plot(tables, options.plot)


if __name__ == "__main__":
    main()
