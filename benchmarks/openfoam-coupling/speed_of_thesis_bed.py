#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Seconds per simulated second of the cohesive bed of the thesis (examples/fluidised-bed, Hamaker constant
7.49e-19 J), on one core: scheme exact at a sixth of the contact time, as the example's run.py has it, and at an
eighth, and forces sampled once a step.

    speed_of_thesis_bed.py BUILD WORK [--rest S] [--blow S] [--csv FILE]

Processor time, of the bed at rest, where contacts are most, and blown through at 1.2 m/s, where the thesis's
schedule begins; settling before that is not counted."""

import os
import re
import time

from cohesion_studies.bed import bed_case
from cohesion_studies.foam_case import environment
from cohesion_tests import csv_table, measuring_program
from cohesion_tests.progress import Progress

SCHEMES = {f"{scheme}, t_c/{part}": {"scheme": scheme, "dt": dt}
           for scheme, part, dt in (("exact", 6, 1.5e-5), ("exact", 8, 1.125e-5), ("sampled", 8, 1.125e-5))}
GAS_STEP = 4.5e-4
TICK = os.sysconf("SC_CLK_TCK")


def processor_seconds(pid):
    words = open(f"/proc/{pid}/stat").read().rsplit(")", 1)[1].split()
    return (int(words[11]) + int(words[12])) / TICK


def run(env, folder, parameters, rest, blow):
    """Processor seconds per simulated second at rest and blown through, and the shares of particles and
    exchange in the time of all [%]."""
    case = bed_case.make_case(folder, {"engine": "lammps", "schedule": "thesis", "A": 7.49e-19, **parameters}, env)
    (case.folder / "constant/schedule").write_text(
        f"superficialVelocity table ((0 (0 0 0)) ({rest} (0 0 0)) ({rest + 1e-3} (0 1.2 0)) (9 (0 1.2 0)));\n"
        f"endTime {rest + blow + 2 * GAS_STEP};\n")  # so that it still runs at the last moment
    process = case.start()
    stamps = []
    for moment in (GAS_STEP, rest, rest + blow):
        while process.poll() is None:
            found = re.findall(r"^Time = (\S+)", case.log("cohesiveBedFoam").read_text(), re.M)
            if found and float(found[-1]) > moment - 0.5 * GAS_STEP:
                break
            time.sleep(0.01)
        if process.poll() is None:
            stamps.append((float(found[-1]), processor_seconds(process.pid)))
    case.finish(process)
    assert len(stamps) == 3, "the run ended before it was looked at"
    log = case.log("cohesiveBedFoam").read_text()
    shares = [float(re.search(rf"^    {row} +\S+ s, (\S+) %", log, re.M)[1])
              for row in ("particles", "exchange")]
    return [(b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(stamps, stamps[1:])], shares


def main():
    parser = measuring_program.coupling_parser(__doc__, table=True)
    parser.add_argument("--rest", type=float, default=0.045, help="seconds at rest (%(default)s)")
    parser.add_argument("--blow", type=float, default=0.3, help="seconds blown through (%(default)s)")
    args = parser.parse_args()
    env, progress = environment(args.build), Progress(len(SCHEMES))
    rows = []
    for name, parameters in SCHEMES.items():
        rows.append((name, *run(env, f"{args.work}/{name.replace(', t_c/', '-')}", parameters, args.rest, args.blow)))
        progress.add(1)
    print("\n| scheme, step | s per simulated second, at rest | blown through | particles, exchange |\n"
          "|---|---|---|---|")
    for name, seconds, shares in rows:
        print(f"| {name} | " + " | ".join(f"{value:.0f}" for value in seconds)
              + f" | {shares[0]:.0f} %, {shares[1]:.1f} % |")
        csv_table.enter_quantities(args.csv, "speed", f"cohesive bed of the example, {name}", {
            "seconds per simulated second at rest": f"{seconds[0]:.0f}", "seconds per simulated second in flow":
            f"{seconds[1]:.0f}", "particles [%]": f"{shares[0]:.0f}", "exchange [%]": f"{shares[1]:.1f}"})


if __name__ == "__main__":
    main()
