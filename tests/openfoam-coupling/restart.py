# SPDX-License-Identifier: BSD-3-Clause
"""A swarm of falling, colliding spheres, killed (signal 9) at random moments and continued with
`startFrom latestTime`: the same gas, particles and forces at the end as without the stops, on 1 and 2
ranks. Time folders that are not complete are set aside, also one that was cut off while it was written,
on some ranks before others; what cannot be continued, and what would overwrite results, is refused."""

import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time

import numpy as np

from cohesion_studies.foam_case import CaseError
from cohesion_tests.coupling.cases import ENGINE, Expectations, column, disturb, exchange_lines, use_script
from packed_bed import field

COUPLING, CONTROL = "constant/couplingProperties", "system/controlDict"
END, INTERVAL = "0.02", 0.004
STEPS = 200
# A run that is continued has to be nearer to the whole one than one whose velocities are off by this
# share at the start; see disturb(). Far above what the solver of p leaves, 1e-13 a step.
DISTURBANCE = 1e-9


def make(build, work, name, script="continued"):
    case = column(work, name, build)
    use_script(case, script)
    case.set(COUPLING, "voidFraction", "sphereOverlap")
    case.set(CONTROL, "endTime", END)
    case.set(CONTROL, "writeInterval", INTERVAL)
    # All digits, so that a written state is the state
    case.set(CONTROL, "writePrecision", 17)
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    case.mesh()
    return case


def make_to_kill(build, work, name, ranks):
    """A case that goes on from the latest time, divided among the ranks."""
    case = make(build, work, name)
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


def numbers(path, columns):
    found = re.search(r"\n\d+\s*\n?\((.*)\)", path.read_text(), re.S)
    return np.array(re.sub(r"[()]", " ", found[1]).split(), float).reshape(-1, columns)


def kill_after(case, steps, ranks):
    """Starts the solver and kills one of its ranks when its log has `steps` steps; whether it was in
    time. The others are ended by mpirun, wherever they are."""
    process = case.start(ranks=ranks)
    while process.poll() is None and steps_begun(case) < steps:
        time.sleep(0.005)
    return kill(case, process, ranks)


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


def check_killed(expect, build, work, ranks, kills, reference):
    """Kills after each of `kills` steps, counted from where the run is continued."""
    case = make_to_kill(build, work, f"killed-{ranks}", ranks)
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


def difference(found, reference):
    """By name: the largest difference over the largest value."""
    return {name: np.abs(found[name] - expected).max() / np.abs(expected).max()
            for name, expected in reference.items()}


def compare(expect, what, found, reference):
    """reference: the state of the whole run, and the difference that a disturbance makes."""
    whole, limits = reference
    for name, apart in difference(found, whole).items():
        expect.below(f"{what}: {name}, largest difference / largest value", apart, limits[name])


def check_cut_off(expect, build, work, ranks, reference):
    """Ended while the last time was written: half a file, no mark, and on the last of several ranks no
    folder. Of an earlier end at the same time a folder is there. Two times are kept, so that there is
    one to continue from."""
    case = make(build, work, f"cut-off-{ranks}")
    case.set(CONTROL, "endTime", 0.012)
    case.set(CONTROL, "purgeWrite", 2)
    case.solve(ranks=ranks)
    folder = case.folder / "processor0" if ranks > 1 else case.folder
    expect.equal(f"cut off, {ranks} ranks: times kept", complete(case, ranks), [0.008, 0.012])
    cut = folder / "0.012"
    (cut / "uniform/completeState").unlink()
    text = (cut / "U").read_text()
    (cut / "U").write_text(text[:len(text) // 2])
    if ranks > 1:
        shutil.rmtree(case.folder / f"processor{ranks - 1}/0.012")
    (folder / "incomplete-0.012").mkdir()
    (folder / "incomplete-0.012/earlier").touch()
    case.set(CONTROL, "endTime", END)
    case.set(CONTROL, "startFrom", "latestTime")
    case.finish(case.start(ranks=ranks))
    log = case.log("cohesiveBedFoam").read_text()
    expect.true(f"cut off, {ranks} ranks: it says what was set aside",
                "Time folders after 0.008 are incomplete" in log)
    expect.true(f"cut off, {ranks} ranks: the folder is kept",
                (folder / "incomplete-0.012.2/U").exists())
    expect.true(f"cut off, {ranks} ranks: that of an earlier end, too",
                (folder / "incomplete-0.012/earlier").exists())
    compare(expect, f"cut off, {ranks} ranks", state(case, log, ranks), reference)


def refused(expect, what, case, *parts, options=()):
    try:
        case.solve(*options)
        expect.true(f"{what}: stops", False)
    except CaseError:
        text = " ".join(case.log("cohesiveBedFoam").read_text().split())
        for part in parts:
            expect.true(f"{what}: says \"{part}\"", part in text)


def check_refused(expect, build, work):
    case = make(build, work, "refused", "swarm")
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


def check_results_are_kept(expect, build, work):
    """Results after the start are overwritten with -overwrite only, and then none of them passes for
    complete any more; nor are results without any mark renamed unasked."""
    case = make(build, work, "kept")
    case.set(CONTROL, "endTime", 0.012)
    log = case.solve()
    expect.true("no warning of digits", "fields are written with" not in log)
    case.set(CONTROL, "startTime", 0.004)
    written = (case.folder / "0.008/U").stat().st_mtime_ns
    refused(expect, "start before the last complete time", case, "after the start at 0.004",
            "at 2 times from 0.008 to 0.012", "-overwrite")
    expect.equal("start before the last complete time: all are complete", complete(case, 1),
                 [0.004, 0.008, 0.012])
    # Five steps: none is written.
    case.set(CONTROL, "endTime", 0.0045)
    case.solve("-overwrite")
    expect.equal("overwritten from 0.004 on: complete", complete(case, 1), [0.004])
    expect.equal("overwritten from 0.004 on: not yet at 0.008",
                 (case.folder / "0.008/U").stat().st_mtime_ns, written)

    (case.folder / "0.004/uniform/completeState").unlink()
    case.set(CONTROL, "startFrom", "latestTime")
    refused(expect, "no time is complete", case, "3 of them, but none with 'uniform/completeState'",
            "-overwrite")
    expect.true("no time is complete: nothing is renamed", (case.folder / "0.012/U").exists())
    log = case.solve("-overwrite")
    expect.true("no time is complete, -overwrite: starts at 0", "\nTime = 0.0001 " in log)
    expect.true("no time is complete, -overwrite: set aside", (case.folder / "incomplete-0.012/U").exists())


def check_not_written(expect, build, work):
    """A field that cannot be written: its name is that of a folder."""
    case = make(build, work, "not-written")
    case.set(CONTROL, "writePrecision", 12)
    (case.folder / "0.004/U").mkdir(parents=True)
    refused(expect, "a field that cannot be written", case, "time 0.004 could not be written in full",
            "fields are written with 12 digits", "writePrecision 17", options=["-overwrite"])
    expect.equal("a field that cannot be written: complete", complete(case, 1), [])


def undisturbed(expect, build, work):
    """The state at the end of the whole run, and the difference that a disturbance makes."""
    whole, disturbed = make(build, work, "whole"), make(build, work, "disturbed")
    disturb(disturbed, "continued", DISTURBANCE)
    end, other = (state(case, case.solve(), 1) for case in (whole, disturbed))
    limits = difference(other, end)
    for name, limit in limits.items():
        # Chaos would make the yardstick as long as the values, and nothing would be compared.
        expect.below(f"disturbed: {name}, largest difference / largest value", limit, 1e-4)
    return end, limits


def main(build, work):
    expect = Expectations()
    reference = undisturbed(expect, build, work)
    draw = random.Random(20)
    # Moments between two writes, 40 steps apart, and near one; counted from the last complete time
    check_killed(expect, build, work, 1, [draw.randint(41, 79), draw.randint(1, 39), 40], reference)
    check_killed(expect, build, work, 2, [draw.randint(41, 119)], reference)
    check_refused(expect, build, work)
    if ENGINE == "lammps":
        # What the solver does by itself, with every engine
        for ranks in (1, 2):
            check_cut_off(expect, build, work, ranks, reference)
        check_results_are_kept(expect, build, work)
        check_not_written(expect, build, work)
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:3])
