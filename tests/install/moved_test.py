# SPDX-License-Identifier: BSD-3-Clause
"""An installation in a temporary prefix, moved to another folder: no file of it names where it came from, and its
programs run there, found by its environment file alone.

    moved_test.py CMAKE GENERATOR BUILD SOURCE VERSION"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CMAKE, GENERATOR, BUILD, SOURCE, VERSION = sys.argv[1:6]
HERE = Path(__file__).resolve().parent
KEPT = ("HOME", "LANG", "OMP_NUM_THREADS", "OMPI_MCA_pml")


class Moved(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(keeper.cleanup)
        cls.folder = Path(keeper.name).resolve()
        cls.first = cls.folder / "first"
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", cls.first], check=True, stdout=subprocess.DEVNULL)
        cls.prefix = cls.folder / "elsewhere/second"
        cls.prefix.parent.mkdir()
        cls.first.rename(cls.prefix)
        share = cls.prefix / "share/cohesion"
        cls.tree = (share / (share / "tree").read_text().strip()).resolve()
        cls.before = cls.listing()

    @classmethod
    def tearDownClass(cls):
        # Programs leave an installation as it is: it may belong to somebody else.
        if cls.listing() != cls.before:
            raise AssertionError(f"written into the installation: {sorted(cls.listing() ^ cls.before)}")

    @classmethod
    def listing(cls):
        return {str(file.relative_to(cls.prefix)) for file in cls.prefix.rglob("*")}

    def setUp(self):
        self.work = Path(tempfile.mkdtemp(dir=self.folder))

    def call(self, line, code=0):
        """Output of a line of bash, with the environment file sourced and little else of this package."""
        env = {"PATH": "/usr/bin:/bin", **{name: os.environ[name] for name in KEPT if name in os.environ}}
        done = subprocess.run(["bash", "-c", f". '{self.prefix}/share/cohesion/environment.sh' && {line}"], env=env,
                              cwd=self.work, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, code, done.stdout)
        return done.stdout

    def require(self, file):
        if not (self.tree / file).exists():
            self.skipTest(f"built without {file}")

    def test_no_file_names_where_it_came_from(self):
        names = [os.fsencode(name) for name in (BUILD, SOURCE, self.first)]
        for file in self.prefix.rglob("*"):
            if file.is_symlink():
                self.assertFalse(os.path.isabs(os.readlink(file)), file)
                self.assertTrue(file.exists(), f"{file} leads nowhere")
            elif file.is_file():
                content = file.read_bytes()
                for name in names:
                    self.assertNotIn(name, content, file)

    def test_libraries_are_found_by_the_places_of_files(self):
        elves = [file for file in self.tree.rglob("*") if file.is_file() and file.read_bytes()[:4] == b"\x7fELF"]
        self.assertTrue(elves)
        for file in elves:
            section = subprocess.run(["readelf", "-d", file], check=True, capture_output=True, text=True).stdout
            found = re.search(r"\(RUNPATH\).*\[(.*)\]", section)
            self.assertTrue(found, file)
            ways = found[1].split(":")
            self.assertIn("$ORIGIN", ways, file)
            for way in ways:
                self.assertFalse(way.startswith(str(self.folder)), file)

    def test_lammps(self):
        self.require("lammps/stock/lmp-cohesion")
        script = self.work / "in.pair"
        shutil.copy(HERE / "in.pair", script)
        by_launcher = self.call("lmp-cohesion -in in.pair")
        self.assertEqual(by_launcher.count(f"Cohesion {VERSION}, built for LAMMPS "), 1)
        self.assertIn(f"Cohesion {VERSION}, built for LAMMPS ", (self.work / "log.lammps").read_text())
        preload = self.tree / "lammps/stock/cohesion-preload.so"
        preloaded = self.call(f"LD_PRELOAD='{preload}' lmp -in in.pair")
        rows = [re.findall(r"^ +50 .*", output, re.M) for output in (by_launcher, preloaded)]
        self.assertEqual(len(rows[0]), 1)
        self.assertEqual(*rows)

    def test_liggghts(self):
        self.require("liggghts/liggghts-cohesion")
        shutil.copy(HERE.parent / "support/cohesion_tests/liggghts_scenes/in.two_spheres", self.work)
        values = {"radius1": 5e-4, "radius2": 5e-4, "type1": 1, "type2": 2, "gap": 2e-9, "A": 7.49e-19, "cut": 4e-10,
                  "out": 1e-7, "model": "hooke/stiffness", "tangential": "history"}
        words = " ".join(f"-var {name} {value}" for name, value in values.items())
        forces = []
        for start in ("liggghts-cohesion", f"LD_PRELOAD='{self.tree}/liggghts/cohesion-preload.so' liggghts"):
            output = self.call(f"{start} -in in.two_spheres {words}")
            self.assertEqual(output.count(f"Cohesion {VERSION}\n"), 1)
            forces.append((self.work / "forces.txt").read_text())
        self.assertEqual(*forces)

    def bed(self, engine):
        """One of 0.018 s, by the Python package."""
        self.require(f"openfoam/libcohesion{engine.capitalize()}Engine.so")
        shutil.copytree(self.prefix / "share/cohesion/examples/fluidised-bed/case", self.work / "case")
        (self.work / "case/constant/schedule").write_text(
            "superficialVelocity table ((0 (0 1.2 0)) (1 (0 1.2 0)));\nendTime 0.018;\n")
        shutil.copy(HERE / "small_bed.py", self.work)
        log = self.call(f"python3 -B small_bed.py {engine}")
        self.assertTrue(log.rstrip().endswith("End"), log[-500:])
        self.assertEqual(log.count(f"Cohesion {VERSION}\n"), 1)

    def test_bed_with_lammps(self):
        self.bed("lammps")

    def test_bed_with_liggghts(self):
        self.bed("liggghts")

    def test_mapping(self):
        self.require("tools/cohesion-mapping")
        self.assertEqual(self.call("cohesion-mapping --version").strip(), f"cohesion-mapping, Cohesion {VERSION}")

    def test_powder(self):
        self.require("tools/cohesion-powder")
        self.call("cohesion-powder --diameter 1e-3 --density 2500 --stiffness 100 --width 0.02 --depth 0.02 --height 0.02"
                  " --write case")
        self.assertTrue((self.work / "case/Allrun").exists())

    def test_translate(self):
        self.require("tools/cohesion-translate")
        self.assertEqual(self.call("cohesion-translate --version").strip(), f"cohesion-translate, Cohesion {VERSION}")

    def test_studies(self):
        self.assertIn("fluidised-bed", self.call("cohesion-studies"))
        self.assertIn("--build", self.call("cohesion-studies fluidised-bed study --help"))
        self.assertIn("no example 'fludised-bed'", self.call("cohesion-studies fludised-bed", code=1))
        # Of a file that an installation has, and one of nobody
        self.assertIn("no case of a bed", self.call("cohesion-studies fluidised-bed study "
                                                     "defluidisation-cycle/small.csv --case .", code=1))

    def test_project_that_calls_a_law(self):
        for file in ("CMakeLists.txt", "force.cpp"):
            shutil.copy(HERE / "project" / file, self.work)
        # With the generator of the build: another may not be there.
        output = self.call(f"cmake -S . -B build -G '{GENERATOR}' >log && cmake --build build >>log && build/force")
        # A R*/(6 H^2) of two spheres of 0.5 mm, 2 nm apart
        self.assertAlmostEqual(float(output) / (7.49e-19 / 6 * 0.25e-3 / 2e-9**2), 1, delta=1e-12)

    def test_module(self):
        modules = shutil.which("modulecmd-wrapper") or shutil.which("/usr/lib/x86_64-linux-gnu/modulecmd.tcl")
        if not modules:
            self.skipTest("no environment modules here")
        self.require("tools/cohesion-mapping")
        done = subprocess.run(
            ["bash", "-c", f"eval \"$({modules} bash use {self.prefix}/share/modulefiles)\" && "
             f"eval \"$({modules} bash load cohesion)\" && cohesion-mapping --version"],
            capture_output=True, text=True)
        self.assertIn(VERSION, done.stdout, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
