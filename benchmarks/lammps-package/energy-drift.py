#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Energy of a gas of 1000 elastic spheres over 100 collisions per particle: its drift against the
time step, the scheme and the run time.

  energy-drift.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--collisions N | --heating | --seeds N]
  energy-drift.py LMP_WITH_PLUGIN_COMMAND PLUGIN --damped [--law linear|hertz|dmt|jkr] [--gases N] [--csv FILE]

Scheme exact is gran/hamaker; scheme sampled is LAMMPS' gran/hooke/history, with pair_style hamaker
over it where there is adhesion, at the step that costs the same time as the exact scheme's. Drift is
the total energy minus that of the start, over the kinetic energy of the start: `end` is its mean
over the last tenth of the run, `rms` that of all samples, `largest` the largest. The fitted order is
the slope of rms against the step, from t_c/5 to t_c/40. A sampled run that blew up is marked 'lost'.

With `--heating`: what the dense gases gain per collision, from the third to the last fifth of 20
collisions, mean and standard error of 16 runs, over the kinetic energy of the start.

With `--damped`: dense gases of damped contacts, from a lattice: total energy after 14 collisions over the kinetic
energy of the start, at t_c/80, and how much more is left at longer steps, over what has been lost; mean and standard
error of 16 gases (--gases).

With `--seeds`: `end` of N gases of other velocities, at t_c/10: mean with its standard error, and root mean square.
"""
import numpy

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import cohesive_gas as gas
from cohesion_tests.progress import Progress
from cohesion_tests.theory import hertzian_laws

DIVISIONS = (4, 5, 10, 20, 40)
# Solid fraction, A [J], speed [m/s] (each component). The spheres' F_ad/sqrt(mu K) is 0.022 m/s.
CASES = ((0.1, 0.0, 0.1), (0.5, 0.0, 0.1), (0.1, 2e-18, 0.02), (0.5, 2e-18, 0.02))
SAMPLES = 200
# Restitution and steps per contact of damped gases.
DAMPED = ((0.9, 5.28), (0.9, 10), (0.9487, 5.86), (0.9487, 10), (0.98, 7.98), (0.98, 15), (0.99, 10.03))
HERTZIAN = ((0.9, 10), (0.9, 20), (0.5, 10), (0.5, 20))


def drift(table):
    return (table[:, 1] - table[0, 1]) / table[0, 3]


def end_of(values):
    return values[-len(values) // 10:].mean()


def row(scheme, division, values, seconds):
    if not numpy.isfinite(values).all():
        return f"  {scheme:8s} t_c/{division:<6.3g}      lost {'':23s} {seconds:8.2f}"
    last = end_of(values)
    rms = numpy.sqrt((values**2).mean())
    return (f"  {scheme:8s} t_c/{division:<6.3g} {last:10.2e}  {rms:9.2e}  "
            f"{numpy.abs(values).max():9.2e}  {seconds:8.2f}")


def heating(gas, engine, seeds=16, divisions=(4, 5, 10, 20)):
    progress = Progress(2 * seeds * sum(divisions))
    print("\rsolid fraction 0.5: gain per collision")
    for phi, constant, speed in CASES[1::2]:
        duration = 20 / gas.collision_rate(phi, speed)
        for division in divisions:
            gains = []
            for seed in range(seeds):
                with engine.temporary_folder() as folder:
                    gas.write(folder, 10, phi, speed, seed)
                    table, _ = gas.follow(folder, division, duration, 50, A=constant,
                                          skin=4e-4 if division < 4 else 2e-4)
                fifths = drift(table)[1:].reshape(5, 10).mean(axis=1)
                gains.append((fifths[4] - fifths[2]) / 8)
                progress.add(division)
            print(f"\r  A = {constant:g} J, {speed:g} m/s, t_c/{division:<3d}"
                  f"{numpy.mean(gains):10.1e} +- {numpy.std(gains, ddof=1) / seeds**0.5:.1e}",
                  flush=True)


def damped(gas, engine, law, seeds, file):
    contacts, cases = (DAMPED, CASES[1::2]) if law == "linear" else (HERTZIAN, hertzian_laws.gases(law, 0.5))
    progress = Progress(len(cases) * seeds * sum(division + gas.FINEST for _, division in contacts))
    print(f"\rsolid fraction 0.5: energy that is left at t_c/{gas.FINEST}, and more at longer steps, over what is lost")
    for phi, constant, speed in cases:
        time = gas.contact_time(law, speed)
        for restitution, division in contacts:
            left = numpy.empty((seeds, 2))
            for seed in range(seeds):
                with engine.temporary_folder() as folder:
                    gas.write(folder, 10, phi, speed, seed)
                    left[seed] = [gas.kept(folder, n, phi, speed, A=constant, e=restitution, law=law, time=time)
                                  for n in (gas.FINEST, division)]
                progress.add(division + gas.FINEST)
            more = (left[:, 1] - left[:, 0]) / (1 - left[:, 0].mean())
            result = f"{more.mean():.1e} +- {more.std(ddof=1) / seeds**0.5:.0e}"
            print(f"\r  A = {constant:g} J, e = {restitution:g}: {left[:, 0].mean():.3f}; t_c/{division:<5g} {result}"
                  f"{'':20s}", flush=True)
            row = {"quantity": f"remaining energy against t_c/{gas.FINEST}", "engine": "LAMMPS", "scheme": "exact",
                   "law": law, "solid fraction": f"{phi:g}", "A [J]": f"{constant:g}",
                   "restitution": f"{restitution:g}", "step": f"t_c/{division:.2g}"}
            more = {} if law == "linear" else {"speed [m/s]": f"{speed:g}", "friction": "0"}
            csv_table.enter(file, {**row, **more}, value=result)


def scatter(gas, engine, collisions, seeds):
    durations = [collisions / gas.collision_rate(phi, speed) for phi, _, speed in CASES]
    progress = Progress(seeds * sum(durations))
    for (phi, constant, speed), duration in zip(CASES, durations):
        ends = []
        for seed in range(seeds):
            with engine.temporary_folder() as folder:
                gas.write(folder, 10, phi, speed, seed)
                table, _ = gas.follow(folder, 10, duration, SAMPLES, A=constant)
            ends.append(drift(table)[-SAMPLES // 10:].mean())
            progress.add(duration)
        print(f"\rsolid fraction {phi:g}, A = {constant:g} J, t_c/10: {numpy.mean(ends):.1e} +- "
              f"{numpy.std(ends, ddof=1) / seeds**0.5:.1e}, root mean square "
              f"{numpy.sqrt(numpy.mean(numpy.square(ends))):.1e}{'':20s}", flush=True)


def main():
    words = measuring_program.words(
        __doc__, ("--collisions", {"type": float, "default": 100.0, "help": "per particle"}),
        ("--heating", {"action": "store_true", "help": "what dense gases gain per collision"}),
        ("--damped", {"action": "store_true", "help": "what damped gases keep too much"}),
        ("--law", {"choices": hertzian_laws.LAWS, "default": "linear", "help": "of damped gases"}),
        ("--gases", {"type": int, "default": 16, "help": "of --damped"}),
        ("--seeds", {"type": int, "metavar": "N", "help": "N gases at t_c/10, at least two"}), csv_table.OPTION)
    if words.csv and not words.damped:
        raise SystemExit("--csv: with --damped")
    csv_table.require_published(words, gases=16)
    if words.heating:
        heating(gas, engine)
        return
    if words.damped:
        damped(gas, engine, words.law, words.gases, words.csv)
        return
    if words.seeds:
        scatter(gas, engine, words.collisions, words.seeds)
        return
    collisions = words.collisions
    durations = [collisions / gas.collision_rate(phi, speed) for phi, _, speed in CASES]
    progress = Progress(2 * sum(durations) / gas.CONTACT_TIME * sum(DIVISIONS))
    for (phi, constant, speed), duration in zip(CASES, durations):
        print(f"\rsolid fraction {phi:g}, A = {constant:g} J, {speed:g} m/s: "
              f"{duration / collisions / gas.CONTACT_TIME:.3g} t_c between collisions{'':20s}\n"
              "  scheme   step             end        rms    largest   seconds")
        levels = []
        with engine.temporary_folder() as folder:
            gas.write(folder, 10, phi, speed, seed=4711)
            table, seconds = gas.follow(folder, 10, duration / 5, scheme="sampled", A=constant)
            per_step = seconds / table[-1, 0]
            for division in DIVISIONS:
                table, seconds = gas.follow(folder, division, duration, SAMPLES, A=constant)
                levels.append(numpy.sqrt((drift(table) ** 2).mean()))
                progress.add(duration / gas.CONTACT_TIME * division)
                print("\r" + row("exact", division, drift(table), seconds), flush=True)
                equal = seconds / per_step / (duration / gas.CONTACT_TIME)
                try:
                    table, seconds = gas.follow(folder, equal, duration, SAMPLES,
                                                scheme="sampled", A=constant)
                    print(row("sampled", equal, drift(table), seconds), flush=True)
                except RuntimeError:
                    print(row("sampled", equal, numpy.array([numpy.nan]), numpy.nan), flush=True)
                progress.add(duration / gas.CONTACT_TIME * division)
        order = -numpy.polyfit(numpy.log(DIVISIONS[1:]), numpy.log(levels[1:]), 1)[0]
        print(f"\r  fitted order of scheme exact: {order:.2f}{'':30s}\n", flush=True)


if __name__ == "__main__":
    main()
