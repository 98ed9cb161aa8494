# SPDX-License-Identifier: BSD-3-Clause
"""An example whose engine the build left out ends before it runs anything, with the reason."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(sys.argv.pop(1) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2] / "examples").resolve()
REASON = "{} was not found: run scripts/setup, no header in /nowhere"
LAMMPS = "LAMMPS package: left out, " + REASON.format("LAMMPS")
LIGGGHTS = "LIGGGHTS styles: left out, COHESION_LIGGGHTS is OFF"
COUPLING = "OpenFOAM coupling: left out, " + REASON.format("OpenFOAM")


class LeftOut(unittest.TestCase):
    def stops(self, program, summary, *words, files=()):
        """With a build folder of this summary and these files."""
        with tempfile.TemporaryDirectory(prefix="cohesion-") as name:
            build = Path(name)
            (build / "summary.txt").write_text(f"Cohesion 0.2.0\n  {summary}\n")
            for file in files:
                (build / file).parent.mkdir(exist_ok=True)
                (build / file).touch()
            done = subprocess.run([sys.executable, str(EXAMPLES / program), "--build", name, *words], text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertNotEqual(done.returncode, 0)
            part, reason = summary.split(": left out, ")
            self.assertEqual(done.stdout.strip(),
                             f"{Path(program).name}: the {part} was left out of '{build.resolve()}': {reason}")

    def test_coupling(self):
        self.stops("fluidised-bed/run.py", COUPLING)

    def test_engine_of_a_bed(self):
        coupling = ["openfoam/environment.sh"]
        self.stops("fluidised-bed/run.py", LAMMPS, files=coupling)
        self.stops("fluidised-bed/run.py", LIGGGHTS, "--engine", "liggghts", files=coupling)
        self.stops("bubbling-hard-sphere/run.py", LAMMPS, files=coupling)
        self.stops("measured-beds/run.py", LAMMPS, files=coupling)
        self.stops("spouted-bed/run.py", LIGGGHTS, files=coupling)

    def test_engine_alone(self):
        self.stops("shear/run.py", LAMMPS)
        self.stops("free-cooling/run.py", LAMMPS)
        self.stops("pouring/run.py", LAMMPS.replace("LAMMPS package", "stock LAMMPS"))


if __name__ == "__main__":
    unittest.main()
