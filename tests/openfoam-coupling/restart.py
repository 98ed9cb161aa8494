# SPDX-License-Identifier: BSD-3-Clause
"""A swarm of falling, colliding spheres, killed (signal 9) at random moments and continued with
`startFrom latestTime`: the same gas, particles and forces at the end as without the stops, on 1 and 2
ranks. Time folders that are not complete are set aside, also one that was cut off while it was written,
and what cannot be continued is refused."""

import random
import re
import signal
import subprocess
import sys
import time

import numpy as np

from coupled_case import CaseError, Expectations, column, exchange_lines
from packed_bed import field

COUPLING, CONTROL = "constant/couplingProperties", "system/controlDict"
END, INTERVAL = "0.02", 0.004
STEPS = 200


def make(build, work, name, script="continued.lmp"):
    case = column(work, name, build)
    case.set(COUPLING, "lammpsCoeffs/script", f'"$FOAM_CASE/{script}"')
    case.set(COUPLING, "voidFraction", "sphereOverlap")
    case.set(CONTROL, "endTime", END)
    case.set(CONTROL, "writeInterval", INTERVAL)
    # All digits, so that a written state is the state
    case.set(CONTROL, "writePrecision", 17)
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    case.mesh()
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


def numbers(path, columns):
    found = re.search(r"\n\d+\s*\n?\((.*)\)", path.read_text(), re.S)
    return np.array(re.sub(r"[()]", " ", found[1]).split(), float).reshape(-1, columns)


def kill_after(case, steps, ranks):
    """Starts the solver and kills a rank of it when its log has `steps` steps; whether it was in time."""
    process = case.start(ranks=ranks)
    log = case.log("cohesiveBedFoam")
    while process.poll() is None and log.read_text().count("\nTime = ") < steps:
        time.sleep(0.005)
    if ranks > 1:
        found = subprocess.run(["pgrep", "-P", str(process.pid)], capture_output=True, text=True)
        for pid in found.stdout.split():
            subprocess.run(["kill", "-9", pid])
        process.wait()
        return "signal 9" in log.read_text()
    process.send_signal(signal.SIGKILL)
    return process.wait() == -signal.SIGKILL


def complete(case, ranks):
    folder = case.folder / "processor0" if ranks > 1 else case.folder
    return sorted(float(f.parent.parent.name) for f in folder.glob("[0-9]*/uniform/completeState"))


def check_killed(expect, build, work, ranks, kills, reference):
    """Kills after each of `kills` steps, counted from where the run is continued."""
    case = make(build, work, f"killed-{ranks}")
    if ranks > 1:
        case.set("system/decomposeParDict", "numberOfSubdomains", ranks)
        case.run("decomposePar", "-force")
    case.set(CONTROL, "startFrom", "latestTime")
    for steps in kills:
        done = complete(case, ranks)
        expect.true(f"{ranks} ranks: killed after {steps} steps from {done[-1] if done else 0}",
                    kill_after(case, steps, ranks))
    done = complete(case, ranks)
    expect.true(f"{ranks} ranks: something is kept: {done}", len(done) > 0)
    case.finish(case.start(ranks=ranks))
    log = case.log("cohesiveBedFoam").read_text()
    left = STEPS - round(done[-1] / 1e-4)
    expect.equal(f"{ranks} ranks: steps that were left to do", len(exchange_lines(log)), left)
    compare(expect, f"{ranks} ranks, continued", state(case, log, ranks), reference)


def compare(expect, what, found, reference):
    # The pressure is solved to 1e-13 of its scale in each of 200 steps; a factor 1e4 is left for what
    # collisions make of that and of sums of forces in another order.
    for name, expected in reference.items():
        expect.below(f"{what}: {name}, largest difference / largest value",
                     np.abs(found[name] - expected).max() / np.abs(expected).max(),
                     STEPS * 1e-13 * 1e4)


def check_cut_off(expect, build, work, reference):
    """Ended while the last time was written: half a file, no mark."""
    case = make(build, work, "cut-off")
    case.set(CONTROL, "endTime", 0.012)
    case.solve()
    cut = case.folder / "0.012"
    (cut / "uniform/completeState").unlink()
    text = (cut / "U").read_text()
    (cut / "U").write_text(text[:len(text) // 2])
    case.set(CONTROL, "endTime", END)
    case.set(CONTROL, "startFrom", "latestTime")
    log = case.solve()
    expect.true("cut off: it says what was set aside", "Time folders after 0.008 are incomplete" in log)
    expect.true("cut off: the folder is kept", (case.folder / "incomplete-0.012/U").exists())
    compare(expect, "cut off", state(case, log, 1), reference)


def refused(expect, what, case, *parts):
    try:
        case.solve()
        expect.true(f"{what}: stops", False)
    except CaseError:
        text = " ".join(case.log("cohesiveBedFoam").read_text().split())
        for part in parts:
            expect.true(f"{what}: says \"{part}\"", part in text)


def check_refused(expect, build, work):
    case = make(build, work, "refused", "swarm.lmp")
    case.set(CONTROL, "endTime", 0.008)
    case.solve()
    case.set(CONTROL, "startFrom", "latestTime")
    refused(expect, "script without read_restart", case, "had done 800 steps", "have done 0",
            "read_restart ${restart}", "couplingProperties")
    case.set(CONTROL, "startFrom", "startTime")
    case.set(CONTROL, "startTime", 0.004)
    (case.folder / "0.004/uniform/completeState").unlink()
    refused(expect, "start at a time that is not complete", case, "start at time 0.004",
            "Complete are 0, 0.008", "startFrom latestTime")


def main(build, work):
    expect = Expectations()
    whole = make(build, work, "whole")
    reference = state(whole, whole.solve(), 1)
    draw = random.Random(20)
    # Moments between two writes, 40 steps apart, and near one; counted from the last complete time
    check_killed(expect, build, work, 1, [draw.randint(41, 79), draw.randint(1, 39), 40], reference)
    check_killed(expect, build, work, 2, [draw.randint(41, 119)], reference)
    check_cut_off(expect, build, work, reference)
    check_refused(expect, build, work)
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:])
