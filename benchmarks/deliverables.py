# SPDX-License-Identifier: BSD-3-Clause
"""How large each deliverable is, and what it costs to load it."""
import statistics
import subprocess
import tempfile
from pathlib import Path

from build_folder import Used, environment
from cohesion_tests import instruction_count
from cohesion_tests.progress import Progress
from scenes import spread

# What is installed for whom; the first of them is what is loaded.
FILES = {
    "LAMMPS plugin": ("lammps/{lammps}/cohesion-styles.so", "lammps/{lammps}/cohesionplugin.so"),
    "LAMMPS launcher": ("lammps/{lammps}/lmp-cohesion",),
    "LAMMPS preload": ("lammps/{lammps}/cohesion-preload.so",),
    "LIGGGHTS launcher": ("liggghts/liggghts-cohesion",),
    "LIGGGHTS preload": ("liggghts/cohesion-preload.so",),
    "solver": ("openfoam/cohesiveBedFoam", "openfoam/libcohesionCoupling.so"),
    "engine LAMMPS of the solver": ("openfoam/libcohesionLammpsEngine.so",),
    "engine LIGGGHTS of the solver": ("openfoam/libcohesionLiggghtsEngine.so",),
    "tool cohesion-mapping": ("tools/cohesion-mapping",),
}
EMPTY = "print ready\n"


def add_words(parser):
    parser.add_argument("--turns", type=int, default=15)


def small(words):
    words.turns = 5


def starts(programs):
    """Deliverable: (command without, script), (command with, script); None: there is nothing to start without."""
    build = programs.build
    found = {}
    if programs.has("lammps+"):
        with_command = programs.command("lammps+")
        load = f"plugin load {programs.plugin}\n"
        found["LAMMPS plugin"] = (with_command, EMPTY), (with_command, load + EMPTY)
        found["LAMMPS launcher"] = (programs.command("lammps"), EMPTY), (with_command, EMPTY)
    if programs.has("liggghts+"):
        stock = programs.command("liggghts")
        found["LIGGGHTS launcher"] = (stock, EMPTY), (programs.command("liggghts+"), EMPTY)
        preload = f"LD_PRELOAD={build / 'liggghts/cohesion-preload.so'}"
        found["LIGGGHTS preload"] = (stock, EMPTY), (["env", preload, *stock], EMPTY)
    tool = build / "tools/cohesion-mapping"
    if tool.is_file():
        found["tool cohesion-mapping"] = None, ([str(tool), "--help"], "")
    return found


def timed(start):
    command, script = start
    with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
        (Path(folder) / "in.script").write_text(script)
        return Used(command, folder)


def counted(start):
    command, script = start
    if command[0] == "env":  # valgrind would take the library for itself
        return None
    with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
        (Path(folder) / "in.script").write_text(script)
        return instruction_count.of_command(command, folder, environment())


def stripped(file):
    """Bytes without symbols, as packages ship it."""
    with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
        out = Path(folder) / "stripped"
        subprocess.run(["strip", "--strip-unneeded", "-o", out, file], check=True)
        return out.stat().st_size


def rows(programs, words):
    pairs = starts(programs)
    progress = Progress(len(pairs) * (words.turns + 1))
    yield ("| deliverable | kB | kB stripped | start without [ms] | with [ms] | more: median (least to most) [ms] | "
           "more instructions, millions | more memory [MB] |")
    yield "|---|---|---|---|---|---|---|---|"
    for name, patterns in FILES.items():
        files = [programs.build / pattern.format(lammps=programs.lammps) for pattern in patterns]
        files = [file for file in files if file.is_file()]
        if not files:
            continue
        cells = [f"{sum(file.stat().st_size for file in files) / 1e3:.0f}",
                 f"{sum(map(stripped, files)) / 1e3:.0f}"]
        if name in pairs:
            cells += load(*pairs[name], words.turns, progress)
        else:
            cells += 5 * [""]
        yield f"| {name} | " + " | ".join(cells) + " |"


def load(without, own, turns, progress):
    """The last five cells of a row; times are of processors."""
    times = []
    for _ in range(turns):
        times.append((timed(without) if without else None, timed(own)))
        progress.add(1)
    counts = [start and counted(start) for start in (without, own)]
    progress.add(1)
    alone = [0.0 if a is None else 1e3 * a.seconds for a, _ in times]
    full = [1e3 * b.seconds for _, b in times]
    more = [b - a for a, b in zip(alone, full)]
    memory = statistics.median(b.memory - a.memory for a, b in times) / 1e6 if without else None
    return [f"{statistics.median(alone):.0f}" if without else "", f"{statistics.median(full):.0f}",
            spread(more, 1),
            "" if counts[1] is None else f"{(counts[1] - (counts[0] or 0)) / 1e6:.1f}",
            "" if memory is None else f"{memory:.1f}"]
