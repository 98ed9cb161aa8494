# SPDX-License-Identifier: BSD-3-Clause
"""Runs LAMMPS on the scripts of lammps_scenes and reads what it wrote; or LIGGGHTS, whose command line, data
files and dumps are the same, on scripts of the same names.

The environment names the engine under test:
  COHESION_LMP            program that knows `plugin load`
  COHESION_PLUGIN         plugin built for it
  COHESION_OTHER_PLUGIN   plugin built for another version
  COHESION_SCRIPTS        folder of the scripts, when it is another
  COHESION_MPIEXEC        MPI launcher with the option that sets the number of ranks
"""
import os
import tempfile
from pathlib import Path

from cohesion_tests import dumps as dump_files
from cohesion_tests import launcher

SCENES = Path(__file__).resolve().parent / "lammps_scenes"


def program():
    return os.environ["COHESION_LMP"]


def plugin():
    return os.environ.get("COHESION_PLUGIN", "")


def other_plugin():
    return os.environ.get("COHESION_OTHER_PLUGIN", "")


def script_file(name):
    """Of a script of the scenes."""
    return Path(os.environ.get("COHESION_SCRIPTS", SCENES)) / name


def command(script, ranks=1, lmp=None, **variables):
    """Words that run `script`, the name of one of the scenes or a path."""
    mpiexec = os.environ.get("COHESION_MPIEXEC", "").split()
    return launcher.command(lmp or program(), script_file(script), ranks if ranks > 1 else 0, mpiexec,
                            {"plugin": plugin(), **variables}, log="none")


def start(script, folder, ranks=1, lmp=None, environment=None, timeout=500, each_line=None, **variables):
    """Runs `script` in `folder`; gives exit code and output. Words of launcher.run()."""
    ended = launcher.run(command(script, ranks, lmp, **variables), folder, ranks if ranks > 1 else 0, environment,
                         timeout, each_line)
    return ended.code, ended.output


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
    return [snapshot.sorted() for snapshot in dump_files.read(Path(folder) / name)]


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
