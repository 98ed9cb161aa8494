#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error against run time of the sampled Hamaker force: the head-on escape velocity of the bed's
spheres against the time step, with what it costs.

  step-error.py LMP_WITH_PLUGIN_COMMAND PLUGIN

For each step, couples of graded speed approach with the contact at eight positions within the step.
Printed: the slowest couple that parted and the fastest that was captured, over the velocity of an
exact integration (both 1 when the step is fine), and the seconds that LAMMPS took per couple.
"""
import os
import re
import sys

import numpy

STEPS = (1e-8, 3e-8, 1e-7, 3e-7, 1e-6, 5e-6, 1.125e-5, 2.25e-5)  # [s]; last: the bed's, the thesis's
POSITIONS = 8
# Over the exact escape velocity: coarse over a wide range, fine around it
SPEEDS = numpy.union1d(numpy.geomspace(0.1, 4.0, 60), numpy.linspace(0.98, 1.02, 40))


def main():
    os.environ.update(COHESION_LMP=sys.argv[1], COHESION_PLUGIN=sys.argv[2], OMP_NUM_THREADS="1")
    import lammps_engine as engine
    import two_particles_head_on_test as couple

    exact = couple.escape_velocity()
    # Long enough for a couple just above the exact velocity to part.
    duration = couple.steps_needed(1.0005 * exact) * couple.DT
    print(f"exact escape velocity {exact:.6g} m/s\n"
          "    dt [s]  slowest parted  fastest captured  seconds per couple")
    for dt in STEPS:
        atoms = []
        for speed in exact * SPEEDS:
            for position in range(POSITIONS):
                gap = couple.OUT * 1.001 + speed * dt * position / POSITIONS
                n = len(atoms) // 2
                first = numpy.array([1e-3 + 2e-3 * (n % 25), 1e-3 + 4e-3 * (n // 25), 1e-3])
                second = first + [0.0, couple.DIAMETER + gap, 0.0]
                for x, v in ((first, speed / 2), (second, -speed / 2)):
                    atoms.append({"type": 1, "diameter": couple.DIAMETER,
                                  "density": couple.DENSITY, "x": x, "v": (0.0, v, 0.0)})
        # The approach from up to a step away, and some steps to part, come on top.
        steps = int(duration / dt * 1.5) + 40
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, [(0.0, 0.051), (0.0, 0.14), (0.0, 0.004)], 1)
            output = engine.run("in.head_on", folder, dt=dt, steps=steps, K=couple.STIFFNESS,
                                gamma=couple.DAMPING / couple.MU, A=couple.A, cut=couple.CUT,
                                out=couple.OUT)
            end = engine.dump(folder, "end.txt")
        gaps = numpy.linalg.norm(end[1::2, 1:4] - end[0::2, 1:4], axis=1) - couple.DIAMETER
        parted = (gaps >= couple.OUT).reshape(len(SPEEDS), POSITIONS)
        slowest = SPEEDS[parted.any(axis=1)].min(initial=numpy.inf)
        fastest = SPEEDS[(~parted).any(axis=1)].max(initial=0.0)
        seconds = float(re.search(r"Loop time of (\S+)", output)[1]) / (len(atoms) // 2)
        print(f"{dt:10.3g}  {slowest:14.3f}  {fastest:16.3f}  {seconds:18.2g}", flush=True)


if __name__ == "__main__":
    main()
