# SPDX-License-Identifier: BSD-3-Clause
"""Restart files whose numbers another version of the package laid out are refused."""
import struct
import unittest
from pathlib import Path

from cohesion_tests.test_cases import ScriptTestCase

HEAD = """
plugin load ${plugin}
units si
atom_style sphere
newton off
"""
MAKE = """
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 1 box
create_atoms 1 single 0.002 0.005 0.005 units box
set group all diameter 1e-3 density 2650
comm_modify vel yes
neighbor 1e-4 bin
"""
# Settings, coefficients, and which layout they have.
STYLES = {
    "hamaker": ("cutoff 1e-9 1e-8", "hamaker 1e-19", 3),
    "gran/hamaker": ("", "stiffness 800", 10),
    "gran/squarewell": ("", "stiffness 800 well 1e-12 1.01", 7),
    "gran/liquidbridge": ("", "stiffness 800 bridge 1e-5 1e-5", 6),
    "gran/jkr": ("", "normal hertz 5e6 0.25 surface_energy 0.01", 3),
    "hard/squarewell": ("", "restitution 0.9", 4),
}
MARK = 0x436f6800  # restart_format.h


class Layout(ScriptTestCase):
    def test_another_layout_is_refused(self):
        file = Path(self.folder) / "some.restart"
        for style, (settings, coefficients, layout) in STYLES.items():
            with self.subTest(style):
                self.goes(f"{HEAD}{MAKE}pair_style {style} {settings}\npair_coeff * * {coefficients}\n"
                          "fix move all nve/sphere\ntimestep 1e-7\nrun 1\nwrite_restart some.restart noinit\n")
                read = (f"{HEAD}read_restart some.restart\ncomm_modify vel yes\nneighbor 1e-4 bin\n"
                        "fix move all nve/sphere\ntimestep 1e-7\nrun 1\n")
                self.goes(read)
                content, mark = file.read_bytes(), struct.pack("=i", MARK + layout)
                self.assertEqual(content.count(mark), 1)
                for other in (MARK + layout - 1, 0):
                    file.write_bytes(content.replace(mark, struct.pack("=i", other)))
                    self.stops(read, f"pair_style {style}", "another version of the package", "write_data")

    def test_another_layout_of_the_forces_of_walls_alone_is_refused(self):
        file = Path(self.folder) / "some.restart"
        run = ("pair_style none\ncomm_modify cutoff 2e-3\nfix w all wall/gran/hamaker stiffness 800 xplane 0 NULL\n"
               "fix move all nve/sphere\ntimestep 1e-7\nrun 1\n")
        self.goes(f"{HEAD}boundary f p p\n{MAKE}{run}write_restart some.restart noinit\n")
        read = f"{HEAD}read_restart some.restart\ncomm_modify vel yes\nneighbor 1e-4 bin\n{run}"
        self.goes(read)
        content, mark = file.read_bytes(), struct.pack("=d", MARK + 6)
        self.assertEqual(content.count(mark), 1)
        file.write_bytes(content.replace(mark, struct.pack("=d", MARK + 5)))
        self.stops(read, "scheme exact", "another version of the package", "write_data")

    def test_another_layout_of_the_motion_of_walls_is_refused(self):
        file = Path(self.folder) / "some.restart"
        for style, pair, words, layout in (("wall/gran/hamaker", "gran/hamaker", "stiffness 800", 5),
                                           ("wall/hard/squarewell", "hard/squarewell", "restitution 0.9", 1)):
            run = f"fix w all {style} {words} xplane 0 NULL\nfix move all nve/sphere\ntimestep 1e-7\nrun 1\n"
            self.goes(f"{HEAD}boundary f p p\n{MAKE}pair_style {pair}\npair_coeff * * {words}\n{run}"
                      "write_restart some.restart noinit\n")
            read = f"{HEAD}read_restart some.restart\ncomm_modify vel yes\nneighbor 1e-4 bin\n{run}"
            self.goes(read)
            content, mark = file.read_bytes(), struct.pack("=d", MARK + layout)
            self.assertEqual(content.count(mark), 1)
            file.write_bytes(content.replace(mark, struct.pack("=d", 0.0)))
            with self.subTest(style):
                self.stops(read, f"fix w {style}", "another version of the package", "write_data")


if __name__ == "__main__":
    unittest.main()
