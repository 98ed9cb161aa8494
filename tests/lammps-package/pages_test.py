# SPDX-License-Identifier: BSD-3-Clause
"""Every LAMMPS script of every page runs as it is printed, and every part of one within the script of its page; each
page has a whole one, and each style a script or part that uses it."""
import re
import unittest

from cohesion_tests import lammps, page_scripts
from cohesion_tests.page_blocks import is_complete

DEFAULT = "docs/lammps-package/pair_gran_hamaker.md"


def with_plugin(script):
    """The plugin of the build in the place of the one that a page names."""
    return re.sub(r"(?m)^(\s*plugin\s+load\s+).*$", lambda match: match[1] + lammps.plugin(), script)


def fault(place, *scripts):
    """What the engine says against the last of scripts that run in one folder; warnings of whole ones count, and
    results that the page does not expect."""
    with lammps.temporary_folder() as folder:
        for script in scripts:
            code, output = lammps.run_text(with_plugin(script), folder, environment={"OMP_NUM_THREADS": "1"})
    errors = re.findall(r"(?m)^ERROR.*", output)
    if code != 0 or errors:
        return (errors or [output[-500:]])[0]
    return page_scripts.fault_of_output(place, scripts[-1], output)


class Pages(unittest.TestCase):
    maxDiff = None

    def test_every_script_runs(self):
        cases = list(page_scripts.scripts("lammps", DEFAULT))
        print(f"{len(cases)} scripts and parts of {len({place.split(':')[0] for place, _ in cases})} pages")
        self.assertEqual(page_scripts.run_all(cases, fault), {})

    def test_each_style_has_a_script_that_uses_it(self):
        without = []
        for page in sorted((page_scripts.SOURCE / "docs/lammps-package").glob("*_*.md")):
            for command, style in page_scripts.titled(page.read_text()):
                used = rf"^{command}\b.*\s{re.escape(style)}\b"
                if command in ("pair_style", "fix", "compute") and not page_scripts.uses(
                        used, "lammps", str(page.relative_to(page_scripts.SOURCE))):
                    without.append(style)
        self.assertEqual(without, [])


class Rules(unittest.TestCase):
    """The test sees what it should."""

    def whole(self):
        return next(block.text for block, kind in page_scripts.all_blocks() if kind == "lammps" and block.page == DEFAULT)

    def test_a_wrong_line_is_found(self):
        self.assertIsNone(fault(f"{DEFAULT}:1", self.whole()))
        for wrong in ("newton off", "comm_modify vel yes"):
            spaced = re.sub(r"\s+", r"\\s+", wrong)
            script = re.sub(rf"(?m)^{spaced}\n", "", self.whole())
            self.assertNotEqual(script, self.whole())
            self.assertIsNotNone(fault(f"{DEFAULT}:1", script), wrong)

    def test_a_wrong_part_is_found(self):
        self.assertIn("stifness", fault("page.md:1 part 1", page_scripts.framed("pair_coeff * * stifness 800", self.whole())))

    def test_parts_replace_lines_of_their_kind(self):
        script = page_scripts.framed("pair_style gran/squarewell\npair_coeff 2 2 stiffness 1\nrun 1000", self.whole())
        self.assertTrue(is_complete(script))
        self.assertEqual(script.count("pair_style"), 1)
        self.assertNotIn("hamaker", script)
        self.assertIn("create_box 2 box", script)
        self.assertEqual(re.findall(r"(?m)^run.*", script), ["run 0", "run 0"])


if __name__ == "__main__":
    unittest.main()
