# SPDX-License-Identifier: BSD-3-Clause
"""Files of `restart N`: a run from one is the unbroken run, with stretched necks and bridges, springs of friction, and
a wall, at steps at which no lists of neighbours are due."""
import unittest

import numpy

from cohesion_tests import lammps as engine

RADIUS, STEPS = 5e-4, 240
LINEAR = "stiffness 800 restitution 0.9 friction 0.3 "
# style, keywords, speed of the couples that stick [m/s], step [s]
CASES = (("jkr", "normal hertz 5e6 0.25 surface_energy 0.05 restitution 0.8 friction 0.3", 0.05, 2e-6),
         ("hamaker", LINEAR + "hamaker 2e-12 cutoff 1e-6 2e-5", 0.02, 1e-5),
         ("liquidbridge", LINEAR + "bridge 1e-3 2e-5", 0.1, 1e-5),
         ("squarewell", LINEAR + "well 5e-9 1.01", 0.05, 1e-5))


def couples(speed):
    """Couples across the border between two ranks and beads at a wall, with slip and spin; each at another phase of its
    motion."""
    atoms = []
    for k in range(8):
        gap, slip, y = 1e-7 + 2e-6 * k, 0.1 * speed * (k + 1), -7e-3 + 1.8e-3 * k
        for x, v, omega in (((-RADIUS - gap, y, 0), (speed, slip, 0), (0, 10 * k, 5)),
                            ((RADIUS, y, 0), (-speed / 2, 0, slip), (0, 0, 0)),
                            ((-9e-3 + RADIUS + gap, y, 4e-3), (-speed, slip, 0), (0, 0, 0))):
            atoms.append({"type": 1, "diameter": 2 * RADIUS, "density": 2650, "x": x, "v": v, "omega": omega})
    return atoms


class Continued(unittest.TestCase):
    def end(self, folder, name, first, case, run, ranks):
        """Places, velocities and spins; first: of the script, to the particles."""
        style, words, _, dt = case
        engine.run_text(f"plugin load ${{plugin}}\n{first}neighbor 1e-4 bin\nfix wall all wall/gran/{style} "
                        f"{words} xplane -9e-3 NULL\nfix move all nve/sphere\ntimestep {dt}\n{run}\nwrite_dump all "
                        f"custom {name} id x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g\n",
                        folder, ranks=ranks)
        return numpy.array(engine.dump(folder, name))[:, 1:].reshape(-1, 3, 3)

    def test_a_run_from_a_file_of_restart_is_the_unbroken_run(self):
        for case in CASES:
            pair = f"pair_style gran/{case[0]}\npair_coeff * * {case[1]}\n"
            for step, ranks in ((61, 1), (61, 2), (118, 2)):
                with self.subTest(case[0], step=step, ranks=ranks), engine.temporary_folder() as folder:
                    engine.write_spheres(folder, couples(case[2]), 3 * [(-0.01, 0.01)], 1)
                    first = ("units si\natom_style sphere\nboundary f f f\nnewton off\ncomm_modify vel yes\n"
                             f"read_data data.spheres\n{pair}")
                    whole = self.end(folder, "whole", first, case, f"restart {step} a.*\nrun {STEPS}", ranks)
                    again = f"newton off\ncomm_modify vel yes\nread_restart a.{step}\n"
                    found = self.end(folder, "found", again, case, f"run {STEPS - step}", ranks)
                    # Places are rounded by 1e-18 m, speeds by that over the step, in some hundred steps.
                    for k, room in enumerate((1e-15, 1e-11, 1e-11 / RADIUS)):
                        self.assertLessEqual(numpy.abs(found[:, k] - whole[:, k]).max(), room)


if __name__ == "__main__":
    unittest.main()
