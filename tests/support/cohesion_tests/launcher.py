# SPDX-License-Identifier: BSD-3-Clause
"""Starts engines, LAMMPS and LIGGGHTS, which take the same words, alone and on ranks."""
import os
import subprocess

from cohesion_studies.mpi_start import short_start


def given_program(word):
    """A program or library of a command line (argparse's `type`): engines run in folders of their own, where a relative
    path would lead elsewhere; a bare name is looked for in PATH."""
    return os.path.abspath(word) if os.sep in word else word


class Ended:
    """A process that has ended: its `code`, and its `output`, errors included."""

    def __init__(self, code, output):
        self.code, self.output = code, output


def command(program, script, ranks=0, mpiexec=(), variables=None, log=None):
    """Words that run a script; `ranks`: under the launcher `mpiexec` (words), which takes the number of ranks behind
    them, 0 without it; `variables` of the script, numbers with all their digits; `log`: its file, when it is another
    than the engine's own."""
    words = [*mpiexec, str(ranks)] if ranks else []
    words += [str(program), "-in", str(script), *(["-log", log] if log else [])]
    for name, value in (variables or {}).items():
        words += ["-var", name, f"{value:.17g}" if isinstance(value, float) else str(value)]
    return words


def run(words, folder, ranks=0, environment=None, timeout=500, each_line=None):
    """Runs a command(), or another command of an engine, in `folder`; gives Ended. `environment`: more of it;
    `each_line`: called with every line as soon as it is there. Raises subprocess.TimeoutExpired after `timeout` [s],
    of a command that is waited for without each_line."""
    how = dict(cwd=folder, text=True, errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
               env={**os.environ, **short_start(ranks), **(environment or {})})
    # LIGGGHTS ends one of its own errors in five with bytes from memory that it has freed: errors="replace".
    if each_line is None:
        done = subprocess.run(words, timeout=timeout, **how)
        return Ended(done.returncode, done.stdout)
    lines = []
    with subprocess.Popen(words, **how) as process:
        for line in process.stdout:
            lines.append(line)
            each_line(line)
    return Ended(process.returncode, "".join(lines))
