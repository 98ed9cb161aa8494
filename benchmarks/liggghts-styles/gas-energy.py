#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Energy of a gas of 1000 elastic spheres over 100 collisions per particle in LIGGGHTS, scheme exact: its change
against the time step.

  gas-energy.py LIGGGHTS_COHESION [--collisions N] [--scheme exact|sampled] [--restitution E] [--law linear|hertz|dmt]
      [--csv FILE]

The same gases as of lammps-package/energy-drift.py. Change is the total energy minus that of the start, over the kinetic
energy of the start: `end` is its mean over the last tenth of the run, `most` the largest of 50 samples, `slope` what a
line through them gains in the run, with its standard error. The gas starts without a contact, and the grid shows less
than the energy of a contact: that is in `end` and not in `slope`.
"""
import argparse
import os
import time

import numpy
from scipy.stats import linregress

from cohesion_tests import csv_table
from cohesion_tests.lammps_scenes.cohesive_gas import collision_rate, contact_time
from cohesion_tests.launcher import given_program
from cohesion_tests.liggghts_scenes.elastic_gas import elastic, energy, gas, hertzian, hertzian_energy, kinetic_energy
from cohesion_tests.liggghts_scenes.scene import frames, hamaker
from cohesion_tests.progress import Progress
from cohesion_tests.theory import hertzian_laws
from cohesion_tests.theory.pair_motion import CUT, OUT, Pair

DIVISIONS = (4, 10, 20)
# Solid fraction, A [J], speed [m/s] (each component).
CASES = ((0.1, 0.0, 0.1), (0.5, 0.0, 0.1), (0.1, 2e-18, 0.02), (0.5, 2e-18, 0.02))
SAMPLES = 50


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher", type=given_program)
    words.add_argument("--collisions", type=float, default=100.0, help="per particle")
    words.add_argument("--scheme", choices=("exact", "sampled"), default="exact")
    words.add_argument("--restitution", type=float, default=1.0)
    words.add_argument("--law", choices=("linear", "hertz", "dmt"), default="linear")
    words.add_argument("--fraction", type=float, help="only this solid fraction")
    words.add_argument(csv_table.OPTION[0], **csv_table.OPTION[1])
    words = words.parse_args()
    if words.csv and (words.law != "linear" or words.restitution != 1):
        raise SystemExit("--csv: of elastic gases of linear springs")
    os.environ["COHESION_LAUNCHER"] = words.launcher
    cases = [case for case in (CASES if words.law == "linear" else hertzian_laws.gases(words.law))
             if words.fraction in (None, case[0])]
    durations = [words.collisions / collision_rate(fraction, speed) for fraction, _, speed in cases]
    progress = Progress(sum(durations) * sum(DIVISIONS))
    for case, duration in zip(cases, durations):
        print("\rsolid fraction {:g}, A = {:g} J, {:g} m/s{:30s}\n"
              "  step           end       most      slope            seconds".format(*case, ""))
        for division in DIVISIONS if words.law == "linear" else hertzian_laws.DIVISIONS:
            measure(words, case, duration, division)
            progress.add(duration * division)


def measure(words, case, duration, division):
    fraction, constant, speed = case
    spheres, side = gas(10, fraction, speed=speed)
    models = f"model hooke/stiffness tangential off cohesion hamaker absolute_damping on tangential_damping off " \
             f"scheme {words.scheme}"
    attraction, contacts = hamaker(constant, cut=CUT, out=OUT), elastic(words.restitution)
    of_frame = lambda frame: energy(frame, side, Pair(constant))
    if words.law != "linear":
        models, attraction, contacts = hertzian(words.law, words.restitution, 0.0)
        of_frame = lambda frame: hertzian_energy(frame, side, hertzian_laws.pair(words.law))
    time_of_contact = contact_time(words.law, speed)
    steps = round(duration / time_of_contact * division / SAMPLES) * SAMPLES
    begin = time.perf_counter()
    course = frames(spheres, models, attraction, dt=time_of_contact / division, steps=steps, every=steps // SAMPLES,
                    contacts=contacts, boundary="p p p", box=f"0 {side} 0 {side} 0 {side}", skin=2e-4)
    seconds = time.perf_counter() - begin
    values = numpy.array([of_frame(frame) for frame in course])
    change = (values - values[0]) / kinetic_energy(course[0])
    line = linregress(numpy.arange(1, SAMPLES + 1) / SAMPLES, change[1:])
    print(f"\r  t_c/{division:<5d} {change[-SAMPLES // 10:].mean():10.1e} {change[1:].max():10.1e} "
          f"{line.slope:10.1e} +- {line.stderr:.0e} {seconds:9.1f}", flush=True)
    csv_table.enter(words.csv, csv_table.drift("LIGGGHTS", words.scheme, case, division),
                    value=f"{change[-SAMPLES // 10:].mean():.1e}")


if __name__ == "__main__":
    main()
