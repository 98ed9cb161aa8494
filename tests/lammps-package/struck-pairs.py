#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A pair that sticks, struck by a third sphere: error of pair_style gran/hamaker against the step.

  struck-pairs.py LMP_WITH_PLUGIN_COMMAND PLUGIN

100 triples (struck_pairs.py) against t_c/1000, after 30 t_c. Printed: how many end otherwise (who sticks
to whom), and, of the others, the root mean square of the error of the velocities over the speed of the
third sphere.
"""
import numpy

import measuring_program

DIVISIONS, FINEST = (2, 4, 5, 10, 20, 40), 1000


def main():
    measuring_program.words(__doc__)
    import lammps_engine as engine
    import struck_pairs

    with engine.temporary_folder() as folder:
        struck_pairs.write(folder)
        for friction in (0.0, 0.3):
            exact, stuck, _ = struck_pairs.outcome(folder, FINEST, friction)
            print(f"friction {friction:g}")
            for division in DIVISIONS:
                velocities, sticks, _ = struck_pairs.outcome(folder, division, friction)
                same = (sticks == stuck).all(axis=0)
                error = numpy.linalg.norm(velocities - exact, axis=2) / struck_pairs.SPEEDS[:, None]
                print(f"  t_c/{division:<4d} other outcome {(~same).sum():3d}   root mean square "
                      f"{numpy.sqrt((error[same]**2).mean()):.2g}", flush=True)


if __name__ == "__main__":
    main()
