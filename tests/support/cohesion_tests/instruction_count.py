# SPDX-License-Identifier: BSD-3-Clause
"""Instructions of a run, and misses of its caches, counted by valgrind: they do not depend on what else the machine
does."""
import re
import shutil
import subprocess
import sys

from cohesion_tests import lammps


def of_command(command, folder, environment=None):
    """Of the whole process `command` (words) in `folder`; processes that it starts are not counted."""
    return counted(["--cache-sim=no"], r"I\s+refs", command, folder, environment)


def lines_missed(command, folder, environment, size):
    """Lines of 64 bytes of data that the same process asks for while its caches, the last one of `size` bytes (a power
    of two), do not hold them."""
    return counted(["--cache-sim=yes", f"--LL={size},16,64"], r"LLd misses", command, folder, environment)


def counted(options, what, command, folder, environment):
    """What cachegrind with `options` says `what` is."""
    if not shutil.which("valgrind"):
        sys.exit("instructions are counted with valgrind, which is not installed: apt-get install valgrind")
    command = ["valgrind", "--tool=cachegrind", *options, "--cachegrind-out-file=/dev/null", *map(str, command)]
    done = subprocess.run(command, cwd=folder, env=environment, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    found = re.search(what + r":\s+([\d,]+)", done.stderr)
    if done.returncode != 0 or not found:
        sys.exit(f"{' '.join(command)} ended with code {done.returncode}:\n"
                 f"{done.stdout[-1000:]}{done.stderr[-1000:]}")
    return int(found[1].replace(",", ""))


def instructions(script, folder, **variables):
    """Of the whole process that runs `script`, as lammps.start() takes it, in `folder`, on one rank."""
    return of_command(lammps.command(script, **variables), folder)


def per_step(script, folder, steps, **variables):
    """Of one step, from runs of `steps` and twice as many: the start is not in it."""
    once, twice = (instructions(script, folder, steps=n, **variables) for n in (steps, 2 * steps))
    return (twice - once) / steps
