# SPDX-License-Identifier: BSD-3-Clause
"""Pull-off under a slow load: contacts of gran/hamaker part at F_ad whatever the step, stiffness, restitution, size,
partner and load; a square well holds any slow load. benchmarks/lammps-package/pull-off-ramp.py prints the whole
campaign."""
import re
import sys
import unittest

from cohesion_tests import lammps
from cohesion_tests.lammps_scenes import pull_off
from cohesion_tests.theory.slow_ramp import Grain

# The ramp lags by 1.5e-3 of F_ad by a formula that is right to a factor of order one, and the load is read to 3e-4.
LAG = 3e-3
HEAD = f"""plugin load {lammps.plugin()}
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
"""


class PullOff(unittest.TestCase):
    def check(self, within, division, *grain, scheme="exact", pulled_by="addforce", **partner):
        with self.subTest(division=division, grain=grain, scheme=scheme, pulled_by=pulled_by, **partner):
            found = pull_off.load_at_parting(Grain(*grain, **partner), division, scheme, pulled_by)
            print(f"t_c/{division}, K and e {grain}, {partner}, {scheme}, {pulled_by}: {found:.4f} F_ad", file=sys.stderr)
            self.assertAlmostEqual(found, 1.0, delta=within)

    def test_at_any_step(self):
        for stiffness, restitution, divisions in ((10.0, 0.99, (4, 10, 20)), (50.0, 0.9, (4, 10, 50)),
                                                  (50.0, 0.5, (4, 10, 50)), (500.0, 0.3, (4, 10, 20))):
            for division in divisions:
                self.check(LAG, division, stiffness, restitution)

    def test_any_size(self):
        for diameter in (10e-6, 1e-3):
            self.check(LAG, 10, 500.0, 0.9, diameter)

    def test_load_that_grows_fast_on_a_deep_contact(self):
        # The overlap at rest is 13,000 H_cut; the grain moves with more energy than the barrier of the tail has at
        # (K'/K) F_ad, 0.72 F_ad at t_c/4.
        for division in (4, 5, 8):
            self.check(LAG, division, 10.0, 0.3, 1e-3)

    def test_any_partner_and_load(self):
        for partner in pull_off.PARTNERS:
            for pulled_by in ("addforce",) if partner == "pair" else ("addforce", "gravity"):
                self.check(LAG, 10, 50.0, 0.5, partner=partner, pulled_by=pulled_by)

    def test_pulled_by_a_wall(self):
        for restitution in (0.9, 0.5, 0.3):
            for division in (4, 10, 20):
                self.check(LAG, division, 50.0, restitution, pulled_by="wall")

    def test_a_grain_that_hangs_goes_on_hanging_with_another_step(self):
        for level, holds in ((0.95, True), (1.02, False)):
            for first, then in ((40, 6), (6, 40), (20, 10)):
                with self.subTest(level=level, first=first, then=then):
                    grain = Grain(50.0, 0.9)
                    gap = pull_off.gap_after_another_step(grain, first, then, level)
                    self.assertEqual(gap < grain.force / grain.stiffness, holds)

    def test_a_grain_that_hangs_goes_on_hanging_when_it_is_released(self):
        # These two fixes leave a velocity as it is, with which a grain that still swings would move on.
        held = {"freeze": ("velocity first set 0 0 0\nfix held first freeze", "unfix held"),
                "setforce": ("velocity first set 0 0 0\nfix held first setforce 0 0 0", "unfix held"),
                "no integration": ("unfix move", "fix move all nve/sphere"),
                "displaced off and back": ("velocity first set 0 0 0\nunfix move\nrun 2\n"
                                           "displace_atoms first move -1e-5 0 0 units box\nrun 2\n"
                                           "displace_atoms first move 1e-5 0 0 units box",
                                           "fix move all nve/sphere")}
        for level, holds in ((0.95, True), (1.02, False)):
            for how, (hold, release) in held.items():
                for division in (6, 10):
                    with self.subTest(level=level, how=how, division=division):
                        grain = Grain(50.0, 0.9)
                        gap = pull_off.gap_after_release(grain, division, level, hold, release)
                        self.assertEqual(gap < grain.force / grain.stiffness, holds)

    def test_a_row_of_grains_parts_at_the_adhesion_force(self):
        # Grains hang from a plate and from each other; the load grows by 1.2 F_ad in 5000 contact times.
        for count, restitution, division in ((8, 0.95, 5), (16, 0.3, 10)):
            with self.subTest(count=count, restitution=restitution, division=division):
                grain = Grain(50.0, restitution, partner="pair")
                contact = grain.contact_time / division
                steps, at_rest = 5000 * division, grain.force / 50.0
                words = f"stiffness 50 restitution {restitution} hamaker 1e-19 cutoff 4e-10 1e-7"
                rows = "".join(f"create_atoms 1 single 5e-4 5e-4 {3e-3 - (k + 0.5) * (75e-6 - at_rest) + at_rest / 2:.17g}\n"
                               for k in range(count))
                code, output = self.run_text(f"""{HEAD}
region box block 0 1e-3 0 1e-3 0 3.1e-3
create_box 1 box
neighbor 3e-5 bin
{rows}set group all diameter 75e-6 density 1500
pair_style gran/hamaker
pair_coeff * * {words}
fix plate all wall/gran/hamaker {words} zplane NULL 3e-3
timestep {contact!r}
variable part equal 1.2*step/{steps}
variable load equal -{grain.force!r}*v_part
group last id {count}
fix pull last addforce 0 0 v_load
fix move all nve/sphere
variable fallen equal z[{count}]<{3e-3 - 75e-6 * count - 1e-7!r}
fix stop all halt 1 v_fallen != 0 error continue
run {steps}
print "PARTED $(v_part)"
""")
                self.assertEqual(code, 0, output[-3000:])
                # It falls by 1e-7 m in some ten contact times.
                self.assertAlmostEqual(float(re.search(r"^PARTED (\S+)", output, re.M)[1]), 1.0, delta=0.01)

    def test_sampled(self):
        self.check(LAG, 50, 50.0, 0.5, scheme="sampled")

    def test_a_square_well_holds_any_slow_load(self):
        # At rest at the edge, which has no width, a grain stays there under up to three times depth over width. One that
        # bounces on the edge, which is elastic, gains by the load and leaves when that suffices.
        grain = Grain(50.0, 0.9)
        depth, width = 1.5625e-15, 0.5e-4 * grain.diameter
        words = f"stiffness 50 restitution 0.9 well {depth} 1.0001"
        for division in (4, 10, 50):
            steps = 3000 * division
            load = f"{3 * depth / width!r}*step/{steps}"
            code, output = self.run_text(f"""{HEAD}
region box block 0 1e-3 0 1e-3 0 3e-3
create_box 1 box
neighbor 4e-5 bin
create_atoms 1 single 0.5e-3 0.5e-3 {2e-3 - grain.diameter / 2 - (1 - 1e-6) * width:.17g}
set group all diameter 75e-6
set group all density 1500
pair_style gran/squarewell
pair_coeff * * {words}
fix ceiling all wall/gran/squarewell {words} zplane NULL 2e-3
timestep {grain.contact_time / division!r}
variable load equal -{load}
fix pull all addforce 0 0 v_load
fix move all nve/sphere
run {steps}
print "GAP $(2e-3-z[1]-37.5e-6)"
""")
            self.assertEqual(code, 0, output[-2000:])
            gap = float(output.split("GAP ")[-1].split()[0])
            print(f"square well, t_c/{division}: gap {gap / width:.6f} of the width under 3 D/w", file=sys.stderr)
            # Until the next step knows it, what the load is more than in the step before pushes the grain a little out.
            dt = grain.contact_time / division
            self.assertLess(gap, width + 2 * 3 * depth / width / steps / grain.mass * dt**2)

    def run_text(self, text):
        with lammps.temporary_folder() as folder:
            return lammps.run_text(text, folder)


if __name__ == "__main__":
    unittest.main()
