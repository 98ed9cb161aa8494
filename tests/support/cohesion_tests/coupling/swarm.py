# SPDX-License-Identifier: BSD-3-Clause
"""A swarm of falling, colliding spheres that is killed and continued: its case, its state at the end, and the
yardstick for it."""

import os
import signal
import subprocess

import numpy as np

from cohesion_tests.coupling.cases import CONTROL, COUPLING, disturb, exchange_lines, use_script
from cohesion_tests.coupling.fields import field, numbers

END, INTERVAL = "0.02", 0.004
STEPS = 200
# A run that is continued has to be nearer to the whole one than one whose velocities are off by this
# share at the start; see disturb(). Far above what the solver of p leaves, 1e-13 a step.
DISTURBANCE = 1e-9


def make(column, name, script="continued"):
    case = column(name)
    use_script(case, script)
    case.set(COUPLING, "voidFraction", "sphereOverlap")
    case.set(CONTROL, "endTime", END)
    case.set(CONTROL, "writeInterval", INTERVAL)
    # All digits, so that a written state is the state
    case.set(CONTROL, "writePrecision", 17)
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    case.mesh()
    return case


def make_to_kill(column, name, ranks):
    """A case that goes on from the latest time, divided among the ranks."""
    case = make(column, name)
    if ranks > 1:
        case.set("system/decomposeParDict", "numberOfSubdomains", ranks)
        case.run("decomposePar", "-force")
    case.set(CONTROL, "startFrom", "latestTime")
    return case


def state(case, log, ranks):
    """Numbers of the end of the run, each with its scale."""
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    values = {name: field(case, END, name) for name in ("U", "p", "voidFraction")}
    # Particles by number: ranks and restarts change their order.
    cloud = case.folder / END / "lagrangian/particles"
    order = np.argsort(numbers(cloud / "id", 1)[:, 0])
    values["particle velocity"] = numbers(cloud / "U", 3)[order]
    values["drag"] = np.array(exchange_lines(log)[-1]["drag"])
    return values


def steps_begun(case):
    return case.log("cohesiveBedFoam").read_text().count("\nTime = ")


def kill(case, process, ranks):
    """Whether it still ran."""
    if ranks > 1:
        found = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True)
        for pid in found.stdout.split()[-1:]:
            os.kill(int(pid), signal.SIGKILL)
        process.wait()
        return "signal 9" in case.log("cohesiveBedFoam").read_text()
    process.send_signal(signal.SIGKILL)
    return process.wait() == -signal.SIGKILL


def complete(case, ranks):
    folder = case.folder / "processor0" if ranks > 1 else case.folder
    return sorted(float(f.parent.parent.name) for f in folder.glob("[0-9]*/uniform/completeState"))


def difference(found, reference):
    """By name: the largest difference over the largest value."""
    return {name: np.abs(found[name] - expected).max() / np.abs(expected).max()
            for name, expected in reference.items()}


def undisturbed(column):
    """The state at the end of the whole run, and the difference that a disturbance makes."""
    whole, disturbed = make(column, "whole"), make(column, "disturbed")
    disturb(disturbed, "continued", DISTURBANCE)
    end, other = (state(case, case.solve(), 1) for case in (whole, disturbed))
    return end, difference(other, end)
