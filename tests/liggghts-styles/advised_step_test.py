# SPDX-License-Identifier: BSD-3-Clause
"""Both engines accept the time step and the lines that cohesion-powder prints, where spheres have several contacts and
the fastest one is three times as fast as the impacts that the program has, under gravity."""
import itertools
import unittest

from cohesion_tests import lammps
from cohesion_tests.csv_program import CsvProgram
from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import DENSITY, RADIUS, script, sphere

program = CsvProgram("COHESION_POWDER")

DIAMETER, PITCH, EDGE = 2 * RADIUS, 2.02 * RADIUS, 3
GRAINS = ("--diameter", DIAMETER, "--density", DENSITY, "--hamaker", 1e-19, "--use", "packing")
CONTACTS = {"linear": ("--stiffness", 800),
            "hertz": ("--young", 63e9, "--poisson", 0.3, "--contact", "hertz", "--soft-young", 1e7)}
LAMMPS = """plugin load {plugin}
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
read_data data.spheres
neighbor 2e-4 bin
{lines}
{gravity}
fix move all nve/sphere
run 20
"""
GRAVITY = "fix gravity all gravity 9.81 vector 0 0 -1"
FASTEST = 3  # over the speed of impacts: docs/theory/contact_steps.md


def spheres(speed):
    """A block of spheres, of which the first flies at its neighbour."""
    return [([PITCH * k for k in site], (speed if site == (0, 0, 0) else 0.0, 0.0, 0.0))
            for site in itertools.product(range(EDGE), repeat=3)]


def printed(engine, *words):
    """Speed of the impacts, and the lines of the script."""
    words = (*GRAINS, *words, "--engine", engine)
    code, output, error = program.call(*words)
    if code != 0:
        raise AssertionError(error)
    lines = output[output.index("In a script"):].splitlines()[1:]
    return program.values(*words)["impact_speed"], "".join(line.strip() + "\n" for line in lines)


def run_in_lammps(words):
    speed, lines = printed("lammps", *words)
    with lammps.temporary_folder() as folder:
        lammps.write_spheres(folder, [dict(type=1, diameter=DIAMETER, density=DENSITY, x=x, v=v)
                                      for x, v in spheres(FASTEST * speed)], [(-5e-3, 8e-3)] * 3, 1)
        return lammps.run_text(LAMMPS.format(plugin=lammps.plugin(), lines=lines, gravity=GRAVITY),
                               folder)


def run_in_liggghts(words):
    speed, lines = printed("liggghts", *words)
    text = script([sphere(x, v) for x, v in spheres(FASTEST * speed)], "model hooke", "", run="run 20\n")
    # In the place of the scene's own contacts and step.
    start, end = text.index("fix E all"), text.index("fix move all")
    text = text[:start] + lines + GRAVITY + "\n" + text[end:]
    text = "".join(line for line in text.splitlines(True) if not line.startswith("timestep")).replace(
        "fix move all", next(line for line in lines.splitlines(True) if line.startswith("timestep")) + "fix move all")
    run = Run(text)
    return run.code, run.output


class AdvisedStep(unittest.TestCase):
    def test_both_engines_accept_it(self):
        for contact, restitution, friction in itertools.product(CONTACTS, (0.3, 0.5, 0.9), (0.0, 0.5)):
            words = (*CONTACTS[contact], "--restitution", restitution, "--friction", friction)
            for run in (run_in_lammps, run_in_liggghts):
                with self.subTest(run.__name__, contact=contact, restitution=restitution, friction=friction):
                    code, output = run(words)
                    self.assertEqual(code, 0, output[-3000:])
                    self.assertNotIn("with several contacts", output)

    def test_both_engines_accept_it_where_a_fall_is_faster_than_impacts(self):
        for restitution in (0.3, 0.9):
            words = (*CONTACTS["hertz"], "--restitution", restitution, "--friction", 0.5, "--speed", 0.01)
            for run in (run_in_lammps, run_in_liggghts):
                with self.subTest(run.__name__, restitution=restitution):
                    code, output = run(words)
                    self.assertEqual(code, 0, output[-3000:])
                    self.assertNotIn("with several contacts", output)


if __name__ == "__main__":
    unittest.main()
