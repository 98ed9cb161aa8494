# SPDX-License-Identifier: BSD-3-Clause
"""Face-centred cubic packings of gran/hamaker in a periodic box that keeps them under a tension of nearly F_ad: they are in
equilibrium, and come to rest at every step that the set-up accepts, however small or large their first velocities are."""
import math
import re
import unittest

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase

K, F_AD, MASS = 800.0, 7.49e-19 * 2.5e-4 / 6 / 4e-10**2, 2650 * math.pi / 6 * 1e-9
CONTACT_TIME = math.pi * math.sqrt(MASS / 2 / K)  # of the spring without its dashpot


def script(restitution, division, overlap, speed, shift=0.0):
    """overlap: of all contacts, over F_ad/K; speed: largest component [m/s]; shift: of each sphere, over F_ad/K."""
    side = (1e-3 - overlap * F_AD / K) * math.sqrt(2)
    random = "".join(f"variable v{axis} atom {speed!r}*(random(-1,1,{seed}))\n" for axis, seed in zip("xyz", (77, 78, 79)))
    return f"""plugin load ${{plugin}}
units si
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
lattice fcc {side:.17g}
region b block 0 3 0 3 0 3
create_box 1 b
create_atoms 1 box
set group all diameter 1e-3 density 2650
{random}velocity all set v_vx v_vy v_vz
displace_atoms all random {3 * (f"{shift * F_AD / K!r} ")} 15485863 units box
neighbor 1e-4 bin
pair_style gran/hamaker
pair_coeff * * stiffness {K} restitution {restitution} hamaker 7.49e-19 cutoff 4e-10 1e-7
fix mv all nve/sphere
timestep {CONTACT_TIME / division!r}
variable part equal -press*vol/(2*atoms*{F_AD!r}*1e-3)
thermo_style custom step ke v_part press
thermo_modify format float %.12g norm no
thermo {round(20 * division)}
run {round(100 * division)}
"""


class Packing(ScriptTestCase):
    def rows(self, *args, **more):
        output = self.goes(script(*args, **more))
        return [[float(word) for word in row] for row in re.findall(r"^ *(\d+) +(\S+) +(\S+) +\S+ *$", output, re.MULTILINE)]

    def test_holds_from_its_first_step(self):
        for restitution, division, overlap in ((0.9, 5, 0.1), (0.9, 10, 0.01), (0.5, 6, 0.1), (0.3, 10, 0.02)):
            for speed in (0.0, 1e-9, 1e-6):
                with self.subTest(restitution=restitution, division=division, overlap=overlap, speed=speed):
                    last = self.rows(restitution, division, overlap, speed)[-1]
                    # The mean velocity remains: a third of the energy of one sphere in 108 at most, here of all.
                    self.assertLessEqual(last[1], 108 * 1.5 * MASS * speed**2 + 1e-30)
                    # The spring of a contact under tension bears from F_ad - K_t x to F_ad - K x.
                    self.assertGreater(last[2], 1 - 1.6 * overlap)
                    self.assertLess(last[2], 1 - 0.9 * overlap)

    def test_comes_to_rest_at_the_longest_step_that_is_accepted(self):
        for restitution in (0.9, 0.5, 0.3):
            code, output = engine.run_text(script(restitution, 3.0, 0.2, 0.0), self.folder)
            self.assertNotEqual(code, 0)
            longest = float(re.search(r"unstable, .*reduce it to ([^ ,]+),", output)[1])
            with self.subTest(restitution=restitution, division=CONTACT_TIME / longest):
                last = self.rows(restitution, CONTACT_TIME / longest, 0.2, 0.0, shift=1e-3)[-1]
                # The energy of the shifts, 54 contacts each of which is off by 1e-3 F_ad/K, and not more.
                self.assertLess(last[1], 108 * 6 * 0.5 * F_AD**2 / K * 1e-6)
                self.assertGreater(last[2], 1 - 1.9 * 0.2)


if __name__ == "__main__":
    unittest.main()
