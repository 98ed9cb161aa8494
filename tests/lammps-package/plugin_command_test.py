# SPDX-License-Identifier: BSD-3-Clause
"""Loading the plugin: what must work in every engine, and what must be refused."""
import os
import re
import shutil
import unittest
from pathlib import Path

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase

BOX = """
units si
atom_style sphere
region box block 0 1 0 1 0 1
create_box 1 box
"""
USE = BOX + "pair_style hamaker cutoff 4e-10 1e-7\nprint 'style is there'\n"
PRELOAD = os.environ.get("COHESION_PRELOAD", "")  # set for an engine without the command


class Loading(ScriptTestCase):
    def goes(self, script, **options):
        output = super().goes(script, **options)
        self.assertIn("style is there", output)
        return output

    def stops(self, script, *words, **options):
        """The loader's own messages stand beside the error."""
        output = super().stops(script, **options)
        for word in words:
            self.assertIn(word, output)
        return output


class Plugin(Loading):
    def test_load(self):
        self.goes("plugin load ${plugin}\n" + USE)

    def test_load_twice(self):
        self.goes("plugin load ${plugin}\nplugin load ${plugin}\n" + USE)

    def test_load_on_two_ranks(self):
        output = self.goes("plugin load ${plugin}\n" + USE, ranks=2)
        # Of the first rank alone: a line of another comes into one of the first's.
        self.assertEqual(output.count("Cohesion "), 1, output)

    def test_load_again_after_clear(self):
        self.goes("plugin load ${plugin}\nclear\nplugin load ${plugin}\n" + USE)

    def test_plugin_of_another_version_is_refused(self):
        output = self.stops("plugin load ${plugin}\n" + USE, "ERROR: the COHESION plugin was built",
                            "build it against the engine", plugin=engine.other_plugin())
        engine_version = re.search(r"LAMMPS \((\d+ \w+ \d+)", output)[1]
        refusal = next(line for line in output.splitlines() if "ERROR" in line)
        versions = re.findall(r"\d+ [A-Z][a-z]+ \d{4}", refusal)
        self.assertEqual(len(versions), 2, refusal)
        self.assertEqual(versions[1], engine_version)
        self.assertNotEqual(versions[0], versions[1])

    def test_plugin_without_its_styles_is_refused(self):
        shutil.copy(engine.plugin(), self.folder)
        alone = str(Path(self.folder) / Path(engine.plugin()).name)
        self.stops("plugin load ${plugin}\n" + USE, "ERROR", "cohesion-styles.so",
                   "must stand beside the plugin", plugin=alone)

    def test_styles_file_of_something_else_is_refused(self):
        shutil.copy(engine.plugin(), self.folder)
        alone = Path(self.folder) / Path(engine.plugin()).name
        shutil.copy(engine.plugin(), alone.with_name("cohesion-styles.so"))
        self.stops("plugin load ${plugin}\n" + USE, "ERROR", "has no function", plugin=str(alone))

    def test_missing_file(self):
        # An engine that has the command itself only notes this; the next line stops it.
        output = self.stops("plugin load ${plugin}\n" + USE, "nowhere.so", "No such file", "ERROR",
                            plugin="./nowhere.so")
        self.assertNotIn("style is there", output)


@unittest.skipUnless(PRELOAD, "this LAMMPS has a plugin command of its own")
class AddedCommand(Loading):
    def test_missing_file(self):
        self.stops("plugin load ${plugin}\nprint 'went on'\n", "ERROR: plugin load",
                   "'./nowhere.so'", "No such file", "LD_LIBRARY_PATH", plugin="./nowhere.so")

    def test_file_that_is_no_plugin(self):
        self.stops("plugin load ${plugin}\n", "ERROR", "libm.so.6", "lammpsplugin_init",
                   plugin="libm.so.6")

    def test_file_that_is_no_library(self):
        broken = Path(self.folder) / "broken.so"
        broken.write_text(1000 * "this is not a library\n")
        self.stops("plugin load ${plugin}\n", "ERROR", str(broken), "invalid ELF header",
                   plugin=str(broken))

    def test_other_words(self):
        self.stops("plugin unload pair hamaker\n", "ERROR", "plugin load FILE")
        self.stops("plugin load\n", "ERROR", "plugin load FILE")

    def test_file_beside_the_launcher_needs_no_path(self):
        self.goes("plugin load ${plugin}\n" + USE, plugin=Path(engine.plugin()).name)

    def test_styles_come_back_after_clear(self):
        self.goes("plugin load ${plugin}\nclear\n" + USE + "fix g all gas/coupling\nclear\n" + USE)

    def test_preloaded(self):
        plain = os.environ["COHESION_PLAIN_LMP"]
        options = {"lmp": plain, "environment": {"LD_PRELOAD": PRELOAD},
                   "plugin": Path(engine.plugin()).name}
        self.goes("plugin load ${plugin}\nclear\n" + USE, **options)

    def test_plain_engine_does_not_know_the_command(self):
        # If it did, launcher and preload library would have been tested in vain.
        self.stops("plugin load ${plugin}\n", "ERROR", "Unknown command",
                   lmp=os.environ["COHESION_PLAIN_LMP"])


if __name__ == "__main__":
    unittest.main()
