# SPDX-License-Identifier: BSD-3-Clause
"""Runs LAMMPS on the scripts beside this file and reads what it wrote; or LIGGGHTS, whose command line, data
files and dumps are the same, on scripts of the same names.

The environment names the engine under test:
  COHESION_LMP            program that knows `plugin load`
  COHESION_PLUGIN         plugin built for it
  COHESION_OTHER_PLUGIN   plugin built for another version
  COHESION_SCRIPTS        folder of the scripts, when it is another
  COHESION_MPIEXEC        MPI launcher with the option that sets the number of ranks
"""
import os
import subprocess
import tempfile
from pathlib import Path

import numpy

from printed_thermo import thermo, thermo_lines  # noqa: F401 (for those who import this)
from short_start import short_start

SCRIPTS = Path(os.environ.get("COHESION_SCRIPTS", Path(__file__).resolve().parent))
LMP = os.environ["COHESION_LMP"]
PLUGIN = os.environ.get("COHESION_PLUGIN", "")
OTHER_PLUGIN = os.environ.get("COHESION_OTHER_PLUGIN", "")
MPIEXEC = os.environ.get("COHESION_MPIEXEC", "").split()


def start(script, folder, ranks=1, lmp=LMP, environment=None, timeout=500, **variables):
    """Runs `script` (a file beside this one) in `folder`; gives exit code and output."""
    variables.setdefault("plugin", PLUGIN)
    command = [*MPIEXEC, str(ranks)] if ranks > 1 else []
    command += [lmp, "-in", str(SCRIPTS / script), "-log", "none"]
    for name, value in variables.items():
        text = f"{value:.17g}" if isinstance(value, float) else str(value)
        command += ["-var", name, text]
    done = subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, timeout=timeout,
                          env={**os.environ, **short_start(ranks), **(environment or {})})
    return done.returncode, done.stdout


def run(script, folder, **options):
    code, output = start(script, folder, **options)
    if code != 0:
        raise RuntimeError(f"{script} ended with code {code}:\n{output[-3000:]}")
    return output


def run_text(text, folder, **options):
    """Like start(), for a script given as text."""
    file = Path(folder) / "in.script"
    file.write_text(text)
    return start(file, folder, **options)


def dumps(folder, name):
    """All snapshots of a dump file with columns of numbers, each sorted by the first column."""
    tables = []
    for text in (Path(folder) / name).read_text().split("ITEM: TIMESTEP")[1:]:
        rows = text[text.index("\n", text.rindex("ITEM:")):].strip().splitlines()
        table = numpy.array([[float(word) for word in row.split()] for row in rows])
        tables.append(table[table[:, 0].argsort()] if table.size else table)
    return tables


def dump(folder, name):
    """Last snapshot of a dump file."""
    return dumps(folder, name)[-1]


def write_spheres(folder, atoms, box, types, name="data.spheres", tilt=None):
    """LAMMPS data file; atoms: dicts with type, diameter, density, x, and perhaps v and
    omega. tilt: xy, xz, yz of a triclinic box."""
    lines = ["spheres", "", f"{len(atoms)} atoms", f"{types} atom types", ""]
    for (low, high), axis in zip(box, "xyz"):
        lines.append(f"{low:.17g} {high:.17g} {axis}lo {axis}hi")
    if tilt is not None:
        lines.append("{:.17g} {:.17g} {:.17g} xy xz yz".format(*tilt))
    lines += ["", "Atoms # sphere", ""]
    for number, atom in enumerate(atoms, 1):
        x = " ".join(f"{value:.17g}" for value in atom["x"])
        lines.append(f"{number} {atom['type']} {atom['diameter']:.17g} {atom['density']:.17g} {x}")
    lines += ["", "Velocities", ""]
    for number, atom in enumerate(atoms, 1):
        v = " ".join(f"{value:.17g}" for value in atom.get("v", (0.0, 0.0, 0.0)))
        spin = " ".join(f"{value:.17g}" for value in atom.get("omega", (0.0, 0.0, 0.0)))
        lines.append(f"{number} {v} {spin}")
    (Path(folder) / name).write_text("\n".join(lines) + "\n")


def temporary_folder():
    return tempfile.TemporaryDirectory(prefix="cohesion-")
