# SPDX-License-Identifier: BSD-3-Clause
"""Units in which force is mass times acceleration give the same motion as SI; the others are refused."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase

# Length [m], mass [kg], time [s] of each.
SAME = {"si": (1, 1, 1), "cgs": (1e-2, 1e-3, 1), "micro": (1e-6, 1e-15, 1e-6), "nano": (1e-9, 1e-21, 1e-9),
        "lj": (1e-3, 1e-9, 1e-4)}
OTHERS = ("real", "metal", "electron")
STEPS = 400


class Scene:
    """Two spheres of 1 mm that stick or rebound, numbers in SI, written in other units."""

    def __init__(self, units):
        self.units = units
        self.length, self.mass, self.time = SAME.get(units, SAME["si"])

    def number(self, value, length=0, mass=0, time=0):
        return repr(value / (self.length**length * self.mass**mass * self.time**time))

    def script(self, pair, walls="", computes=""):
        long = lambda value: self.number(value, length=1)
        places = "".join(f"create_atoms 1 single {long(x)} {long(0.005)} {long(0.005)} units box\n"
                         for x in (0.004, 0.00502))
        return f"""
plugin load ${{plugin}}
units {self.units}
atom_style sphere
boundary p p f
newton off
comm_modify vel yes
region box block 0 {long(0.01)} 0 {long(0.01)} 0 {long(0.01)} units box
create_box 1 box
{places}set group all diameter {long(1e-3)} density {self.number(2650.0, -3, 1)}
group second id 2
velocity second set {self.number(-0.05, 1, 0, -1)} 0 0 units box
neighbor {long(1e-3)} bin
neigh_modify delay 0 every 1 check yes
timestep {self.number(2e-6, time=1)}
{pair}{walls}fix move all nve/sphere
{computes}run {STEPS}
write_dump all custom end.txt id x vx modify format float %.17g sort id
"""

    def contact(self):
        return f"stiffness {self.number(800.0, 0, 1, -2)} restitution 0.8 "

    def energy(self, value):
        return self.number(value, 2, 1, -2)

    def hamaker(self):
        cut, out = self.number(1e-6, 1), self.number(1e-5, 1)
        return f"hamaker {self.energy(5e-19)} cutoff {cut} {out}"

    def pairs(self):
        yield "gran/hamaker", "", self.contact() + self.hamaker()
        yield "gran/hamaker", " scheme sampled", self.contact() + self.hamaker()
        yield "gran/squarewell", "", self.contact() + f"well {self.energy(1e-12)} 1.01"
        force, gap = self.number(1e-7, 1, 1, -2), self.number(1e-6, 1)
        yield "gran/liquidbridge", "", self.contact() + f"bridge {force} {gap}"
        tension, volume = self.number(1e-4, 0, 1, -2), self.number(1e-18, 3)
        yield "gran/liquidbridge", " scheme exact", self.contact() + f"capillary {tension} 0.3 {volume}"
        yield "squarewell", "", f"{self.energy(1e-12)} 1.01"
        yield "hamaker", "", self.hamaker()
        yield "hard/squarewell", "", f"restitution 0.8 well {self.energy(1e-12)} 1.01"


class Units(ScriptTestCase):
    def ends(self, scene, pair):
        self.goes(scene.script(pair))
        end = engine.dump(self.folder, "end.txt")
        speeds = end[:, 2] * scene.length / scene.time
        return numpy.concatenate([end[:, 1] * scene.length, speeds])

    def test_same_motion(self):
        si = {style + settings: self.ends(Scene("si"), f"pair_style {style}{settings}\npair_coeff * * {words}\n")
              for style, settings, words in Scene("si").pairs()}
        for units in SAME:
            scene = Scene(units)
            for style, settings, words in scene.pairs():
                with self.subTest(style + settings, units=units):
                    end = self.ends(scene, f"pair_style {style}{settings}\npair_coeff * * {words}\n")
                    # Roundings of the numbers alone. An impact multiplies that of a place by w0/v, 1e6 at most; a
                    # sampled force at the edge of a well or tail acts a step sooner or later by them.
                    numpy.testing.assert_allclose(end, si[style + settings], rtol=1e-9, atol=1e-12)

    def test_other_units_are_refused(self):
        for units in OTHERS:
            scene = Scene(units)
            for style, settings, words in scene.pairs():
                with self.subTest(style + settings, units=units):
                    self.stops(scene.script(f"pair_style {style}{settings}\npair_coeff * * {words}\n"),
                               f"pair_style {style}: in 'units {units}' force is not mass times acceleration",
                               "use 'units si', 'cgs', 'micro', 'nano' or 'lj'")
        scene = Scene("real")
        for fix in (f"wall/gran/hamaker {scene.contact()} {scene.hamaker()} zplane 0 NULL",
                    f"wall/hamaker {scene.hamaker()} zplane 0 NULL", "gas/coupling"):
            with self.subTest(fix):
                self.stops(scene.script("pair_style none\n", f"fix w all {fix}\n"),
                           f"fix w {fix.split()[0]}: in 'units real' force is not")


if __name__ == "__main__":
    unittest.main()
