# SPDX-License-Identifier: BSD-3-Clause
"""The programs of a build folder and the stock engines that it is for: run on a script given as text, with
processor time and memory, or with instructions counted."""
import os
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from cohesion_studies.mpi_start import short_start
from cohesion_tests import instruction_count


def whole_numbers(text):
    """Of a word of the command line: with commas between them, or as 1e5."""
    return [int(float(number)) for number in text.split(",")]


def environment(ranks=1):
    """Of a start. Ranks that wait let others go on only where there are fewer processors than ranks."""
    own = {**os.environ, **short_start(ranks if ranks > 1 else 0)}
    if ranks > 1:
        own.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                   OMPI_MCA_mpi_yield_when_idle=str(int(ranks > len(os.sched_getaffinity(0)))))
    return own


class Missing(RuntimeError):
    """The build folder lacks what was asked for."""


class Used:
    """What a process took: `seconds` of processors, `memory` of the largest process [byte]; and its
    `output`."""

    def __init__(self, command, folder, ranks=1):
        read, write = os.pipe()
        process = subprocess.Popen(command, cwd=folder, env=environment(ranks), stdin=subprocess.DEVNULL,
                                   stdout=write, stderr=write)
        os.close(write)
        text = []
        with os.fdopen(read, errors="replace") as pipe:
            reader = threading.Thread(target=lambda: text.append(pipe.read()))
            reader.start()
            _, status, used = os.wait4(process.pid, 0)  # children that it waited for are in it
            process.returncode = os.waitstatus_to_exitcode(status)
            reader.join()
        self.output = text[0]
        if process.returncode:
            sys.exit(f"{' '.join(command)} ended with code {process.returncode}:\n{self.output[-2000:]}")
        self.seconds = used.ru_utime + used.ru_stime
        self.memory = used.ru_maxrss * 1024


def side_by_side(works):
    """What functions give, as many at a time as there are processors: for counts, which do not mind."""
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        return list(pool.map(lambda work: work(), works))


class Programs:
    """Of a build folder. `lammps`: which of the LAMMPS engines it was built for."""

    def __init__(self, build, lammps="stock"):
        self.build, self.lammps = Path(build).resolve(), lammps
        cache = self.build / "CMakeCache.txt"
        if not cache.is_file():
            raise Missing(f"{cache} does not exist: configure and build the package first")
        self.cache = dict(line.split("=", 1) for line in cache.read_text().splitlines()
                          if "=" in line and line[0] not in "#/")
        self.plugin = self.build / "lammps" / lammps / "cohesionplugin.so"
        command = self.build / "lammps" / lammps / "lmp-cohesion"
        stock = self._cached(f"LAMMPS_{lammps}_EXECUTABLE:FILEPATH")
        # A LAMMPS that knows `plugin load` needs no launcher.
        self.files = {"lammps": stock, "lammps+": command if command.is_file() else stock,
                      "liggghts": self._cached("LIGGGHTS_EXECUTABLE:FILEPATH"),
                      "liggghts+": self.build / "liggghts/liggghts-cohesion"}
        self.mpiexec = self._cached("MPIEXEC_EXECUTABLE:FILEPATH")

    def _cached(self, name):
        return Path(self.cache.get(name, "NOTFOUND"))

    def has(self, name):
        """Whether engine `name` is there: lammps, liggghts, and with our styles lammps+, liggghts+."""
        return self.files[name].is_file() and (name != "lammps+" or self.plugin.is_file())

    def command(self, name, ranks=1):
        if not self.has(name):
            raise Missing(f"{self.build} has no {name}: build the package for it first")
        start = [str(self.mpiexec), "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        return [*start, str(self.files[name]), "-log", "none", "-in", "in.script"]

    def _in_folder(self, text, steps, do):
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
            script = text.replace("${plugin}", str(self.plugin)).replace("${steps}", str(steps))
            (Path(folder) / "in.script").write_text(script)
            return do(folder)

    def run(self, name, text, steps, ranks=1):
        """What `text` takes with ${steps} replaced: Used."""
        return self._in_folder(text, steps, lambda folder: Used(self.command(name, ranks), folder, ranks))

    def count(self, name, text, steps):
        """Instructions of `text`, one rank."""
        return self._in_folder(text, steps, lambda folder: instruction_count.of_command(
            self.command(name), folder, environment()))

    def missed(self, name, text, steps, size):
        """Lines of 64 bytes that a cache of `size` bytes does not hold when they are asked for."""
        return self._in_folder(text, steps, lambda folder: instruction_count.lines_missed(
            self.command(name), folder, environment(), size))

    def count_per_step(self, name, text, first, steps):
        """Instructions of a step, the mean of `steps` of them after `first`: the start is not in it."""
        start, end = side_by_side([lambda n=n: self.count(name, text, n) for n in (first, first + steps)])
        return (end - start) / steps

    def missed_per_step(self, name, text, first, steps, size):
        """Lines missed in a step, alike."""
        start, end = side_by_side([lambda n=n: self.missed(name, text, n, size) for n in (first, first + steps)])
        return (end - start) / steps

    def seconds_per_step(self, name, text, first, steps):
        """The same in seconds of a processor."""
        start, end = (self.run(name, text, n).seconds for n in (first, first + steps))
        return (end - start) / steps
