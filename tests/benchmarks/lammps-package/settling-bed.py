#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""2028 spheres with damping and friction that settle under gravity, adhesion 0, 1 and 20 weights.

  settling-bed.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--side N] [--layers N] [--seconds S] [--event N ...]
                  [--seed N]

Printed per scheme and step: kinetic energy (rotation included) over that of the start, mean over each
fifth of the run; what of it the liveliest sphere has at the end; the largest speed there; what the energy
tally does not account for, over the largest kinetic energy, in all of the run and in its second half, when
the bed rests; seconds of processor time.
"""
from cohesion_tests import lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import settling_spheres as settling
from cohesion_tests.progress import Progress

SAMPLED = 50  # steps per contact time


def main():
    words = measuring_program.words(
        __doc__, ("--side", {"type": int, "default": 13, "help": "spheres per edge of a layer"}),
        ("--layers", {"type": int, "default": 12}),
        ("--seconds", {"type": float, "default": 0.5, "help": "of the scene's time"}),
        ("--event", {"type": int, "nargs": "+", "default": [4, 10], "metavar": "N",
                     "help": "steps per contact time of the event scheme"}),
        ("--seed", {"type": int, "default": 1}))

    runs = [*(("event", n) for n in words.event), ("sampled", SAMPLED)]
    # A step of the event scheme costs about two and a half of the sampled one's.
    work = {run: run[1] * (2.5 if run[0] == "event" else 1.0) for run in runs}
    progress = Progress(3 * sum(work.values()))
    for ratio in (0, 1, 20):
        print(f"\radhesion {ratio} times the weight{'':30s}\n"
              "  scheme   step      kinetic energy in each fifth                   liveliest  speed [m/s]"
              "   residual    at rest  seconds")
        for scheme, division in runs:
            with engine.temporary_folder() as folder:
                settling.write(folder, words.side, words.layers, seed=words.seed)
                table, seconds = settling.follow(folder, division, words.seconds, scheme=scheme,
                                                 A=settling.hamaker_constant(ratio))
                liveliest = settling.liveliest_share(engine.dump(folder, "end.txt"))
            fifths = (table[1:, 1] / table[0, 1]).reshape(5, -1).mean(axis=1)
            residual = table[:, 3] / table[:, 1].max()
            at_rest = residual[-1] - residual[len(residual) // 2]
            progress.add(work[scheme, division])
            print(f"\r  {scheme:8s} t_c/{division:<4d}" + "".join(f"{k:10.1e}" for k in fifths)
                  + f"{liveliest:12.3f}{table[-1, 2]:13.1e}"
                  + (f"{residual[-1]:11.1e}{at_rest:11.1e}" if scheme == "event" else f"{'':22s}")
                  + f"{seconds:9.1f}", flush=True)


if __name__ == "__main__":
    main()
