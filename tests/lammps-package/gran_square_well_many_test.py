# SPDX-License-Identifier: BSD-3-Clause
"""512 spheres with wells, in LAMMPS: ranks, restarts and energy."""
import unittest
from pathlib import Path

import numpy

from cohesion_tests.lammps_scenes import cohesive_gas as gas
from cohesion_tests.lammps_scenes.square_well_scene import Gas, report, words


class Many(Gas):
    PAIR = ["1 1 " + words(2e-10, 1.1, friction=0.3), "2 2 " + words(1e-10, 1.05, friction=0.1),
            "3 3 " + words(1e-10, 1.2, friction=0.1)]
    FIXES = ["fix w all wall/gran/squarewell " + words(4e-10, 1.1, friction=0.3) +
             " zplane 0 0.0106", "fix g all gravity 9.81 vector 0 0 -1"]

    def end(self, scheme, **options):
        atoms = self.write_gas() if options.get("mode") != "restart" else None
        return self.follow(atoms, self.PAIR, 1e-5, 1000, self.FIXES, self.BOX, boundary="p p f",
                           style="gran/squarewell scheme " + scheme, **options)

    def test_ranks_and_restart(self):
        for scheme in ("exact", "sampled"):
            whole = self.end(scheme)
            table, _ = gas.table(self.output)
            self.assertLess(table[-1, 1], -5e-10)  # wells, and impacts with friction
            self.assertGreater(table[-1, 8:11].min(), 0.0)
            # On two ranks and after a stop sums are in another order. 2^-53 of 1e-2 m, 1e-18 m, ten
            # times a step; in 0.01 s, some three collisions, each multiplies a difference by
            # 2 (path/d) = 10, and the edge, where the normal speed is small, by more: 1e4.
            for name, options in (("two runs", {"mode": "halves"}), ("2 ranks", {"ranks": 2}),
                                  ("writes a restart file", {"mode": "restart_file"}),
                                  ("restart", {"mode": "restart"}),
                                  ("restart on 2 ranks", {"mode": "restart", "ranks": 2})):
                other = self.end(scheme, **options)
                numpy.testing.assert_array_equal(other[:, 0], whole[:, 0])
                difference = numpy.abs(other[:, 1:4] - whole[:, 1:4]).max()
                report(f"{scheme}, {name}: differs by {difference:.1e} m after 1000 steps")
                self.assertLess(difference, 1e-12)

    def test_an_elastic_gas_keeps_its_energy(self):
        # One contact is exact; what errs is several in one step, of second order in it, and at t_c/4
        # no worse than in gran/hamaker, whose gas is good to 5e-4 (energy-drift.py).
        drifts = []
        phi, speed, depth, ratio = 0.3, 0.02, 2e-11, 1.1
        duration = 20 / gas.collision_rate(phi, speed)
        gas.write(self.folder, 8, phi, speed, seed=4711)
        text = (Path(self.folder) / "data.spheres").read_text()
        (Path(self.folder) / "data.spheres").write_text(text.replace("1 atom types", "3 atom types"))
        for division in (4, 10, 20):
            dt = gas.CONTACT_TIME / division
            steps = int(duration / dt)
            self.follow(None, ["* * " + words(depth, ratio, 0.0)], dt, steps, boundary="p p p",
                        every=max(1, steps // 50))
            table, _ = gas.table(self.output)
            # step pe press tally[1..10]: kinetic, rotational, spring, tangential, adhesion, ...
            total = table[:, 3:8].sum(axis=1)
            drift = numpy.abs(total - total[0]).max() / table[0, 3]
            report(f"elastic gas, phi {phi}, D {depth:g} J, ratio {ratio}, t_c/{division}, 20 "
                   f"collisions each: energy within {drift:.1e} of the kinetic energy")
            self.assertLess(drift, 5e-4)
            self.assertLess(table[-1, 7], -depth * 100)  # there are pairs in wells
            drifts.append(drift)
        self.assertLess(drifts[2], drifts[0] / 4)


if __name__ == "__main__":
    unittest.main()
