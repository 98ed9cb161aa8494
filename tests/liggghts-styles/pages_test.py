# SPDX-License-Identifier: BSD-3-Clause
"""Every LIGGGHTS script of every page runs as it is printed, and every part of one within the script of its page; each
page has a whole one, and each style a script or part that uses it."""
import os
import re
import unittest

from cohesion_tests import lammps, page_scripts

DEFAULT = "docs/liggghts-styles/gran_cohesion.md"
PAGES = "docs/liggghts-styles"


def fault(place, *scripts):
    """What the engine says against the last of scripts that run in one folder; warnings of whole ones count, and
    results that the page does not expect."""
    if " part " in place:
        scripts = [page_scripts.with_properties(script) for script in scripts]
    with lammps.temporary_folder() as folder:
        for script in scripts:
            code, output = lammps.run_text(script, folder, lmp=os.environ["COHESION_LAUNCHER"])
    errors = re.findall(r"(?m)^ERROR.*", output)
    if code != 0 or errors:
        return (errors or [output[-500:]])[0]
    return page_scripts.fault_of_output(place, scripts[-1], output)


class Pages(unittest.TestCase):
    maxDiff = None

    def test_every_script_runs(self):
        cases = list(page_scripts.scripts("liggghts", DEFAULT))
        print(f"{len(cases)} scripts and parts of {len({place.split(':')[0] for place, _ in cases})} pages")
        self.assertEqual(page_scripts.run_all(cases, fault), {})

    def test_each_style_has_a_script_that_uses_it(self):
        without = []
        for page in sorted((page_scripts.SOURCE / PAGES).glob("*_*.md")):
            for command, style in page_scripts.titled(page.read_text()):
                used = rf"^(pair_style gran\b.*\bcohesion {style}|{command}\b.*\s{re.escape(style)})\b"
                if command in ("gran cohesion", "fix", "compute") and not page_scripts.uses(
                        used, "liggghts", str(page.relative_to(page_scripts.SOURCE))):
                    without.append(style)
        self.assertEqual(without, [])


class Rules(unittest.TestCase):
    """The test sees what it should."""

    def test_a_wrong_line_is_found(self):
        whole = next(block.text for block, kind in page_scripts.all_blocks()
                     if kind == "liggghts" and block.page == DEFAULT)
        self.assertIsNotNone(fault("page.md:1", whole.replace("cohesion hamaker", "cohesion hamakr")))
        self.assertIsNotNone(fault("page.md:1 part 1", page_scripts.framed("pair_stile gran", whole)))


if __name__ == "__main__":
    unittest.main()
