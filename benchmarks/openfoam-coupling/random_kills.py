#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A swarm (swarm.py), killed (signal 9) at random moments, each time from its start, and continued: which
state is found, how much of the simulated time is lost, and how far the end is from that of the run that was not
killed. Every third kill falls into a write or right after it, at a random moment after the first file was
there.

    random_kills.py BUILD WORK [--kills N] [--ranks N] [--seed N]

Moments are drawn from the seed in steps and shares of a step or of a write; where in a step that is, is the
machine's business. Ends with 1 when more is lost than one interval between writes, or the end is another."""

import os
import random
import re
import sys
import time
from pathlib import Path

from cohesion_tests import measuring_program
from cohesion_tests.coupling.cases import Columns, exchange_lines
from cohesion_tests.coupling.swarm import (END, INTERVAL, STEPS, complete, difference, kill, make_to_kill, state,
                                           steps_begun, undisturbed)
from cohesion_tests.progress import Progress

STEP = float(END) / STEPS
WRITES = round(float(END) / INTERVAL)


def moments(kills, seed):
    """(write or None, steps, share of a step or of a write) of each kill."""
    draw = random.Random(seed)
    return [(draw.randint(1, WRITES - 1) if k % 3 == 2 else None, draw.randint(1, STEPS - 5), draw.random())
            for k in range(kills)]


def last_time(case):
    """That the log has begun [s]."""
    found = re.findall(r"^Time = (\S+)", case.log("cohesiveBedFoam").read_text(), re.M)
    return float(found[-1]) if found else 0.0


def durations(case):
    """Seconds of a step and of a write of the whole run."""
    stamps = []
    for folder in case.glob("0.0*"):
        mark = folder / "uniform/completeState"
        if mark.exists():
            files = [file.stat().st_mtime for file in folder.iterdir() if file.is_file()]
            stamps.append((min(files), mark.stat().st_mtime))
    stamps.sort()
    steps = STEPS * (WRITES - 1) / WRITES
    return ((stamps[-1][0] - stamps[0][0]) / steps, max(end - begin for begin, end in stamps))


def wait(process, case, ranks, moment, seconds):
    """Until the moment has come, or the run has ended."""
    write, steps, share = moment
    folder = case.folder / "processor0" if ranks > 1 else case.folder
    written = folder / f"{INTERVAL * (write or 0):g}"
    while process.poll() is None:
        if os.path.exists(written) if write else steps_begun(case) >= steps:
            break
        time.sleep(0.0005 if write else 0.002)
    # Ranks take turns.
    time.sleep(share * (seconds[1] * ranks if write else seconds[0]))


def killed(column, k, ranks, moment, seconds):
    """The case after the kill, the time it had begun and whether it still ran."""
    case = make_to_kill(column, f"kill-{k}", ranks)
    process = case.start(ranks=ranks)
    wait(process, case, ranks, moment, seconds)
    in_time = kill(case, process, ranks)
    return case, last_time(case), in_time


def cut_off(case, ranks, reached):
    """Whether the time that it had begun has a folder without a mark."""
    folder = (case.folder / "processor0" if ranks > 1 else case.folder) / f"{reached:g}"
    return folder.exists() and not (folder / "uniform/completeState").exists()


def continued(case, ranks, reached, reference):
    """Continues the run; gives the last complete time, the largest difference at the end, and what is wrong."""
    done = complete(case, ranks)
    found = done[-1] if done else 0.0
    # If the first write was cut off, no time is complete: the solver then starts anew with -overwrite.
    case.finish(case.start(*([] if done else ["-overwrite"]), ranks=ranks))
    log = case.log("cohesiveBedFoam").read_text()
    wrong = []
    left, made = STEPS - round(found / STEP), len(exchange_lines(log))
    if made != left:
        wrong.append(f"{made} steps from {found:g} s on, {left} were left to do")
    # A write at the end of an interval that is cut off loses all of it; 1e-9 for the sum of decimal numbers.
    if (reached - found) / INTERVAL > 1 + 1e-9:
        wrong.append(f"{reached - found:g} s are lost, more than an interval")
    whole, limits = reference
    apart = difference(state(case, log, ranks), whole)
    wrong += [f"{name} at the end is off by {apart[name]:.2g} of the largest value, {limits[name]:.2g} is allowed"
              for name in apart if apart[name] >= limits[name]]
    return found, max(apart.values()), wrong


def main():
    parser = measuring_program.coupling_parser(__doc__)
    parser.add_argument("--kills", type=int, default=12, metavar="N")
    parser.add_argument("--ranks", type=int, default=1, metavar="N")
    parser.add_argument("--seed", type=int, default=1, metavar="N")
    args = parser.parse_args()
    column, progress = Columns(args.build, args.work), Progress(args.kills + 1)
    reference, wrong = undisturbed(column), []
    seconds = durations(Path(args.work) / "whole")
    progress.add(1)
    rows = []
    for k, moment in enumerate(moments(args.kills, args.seed)):
        case, reached, in_time = killed(column, k, args.ranks, moment, seconds)
        if not in_time:
            rows.append(("ended before it was killed", reached, "", "", ""))
            wrong.append(f"run {k} ended before it was killed")
            progress.add(1)
            continue
        what = ("write cut off" if cut_off(case, args.ranks, reached)
                else "after a write" if moment[0] else "between writes")
        found, apart, errors = continued(case, args.ranks, reached, reference)
        wrong += [f"run {k}: {error}" for error in errors]
        rows.append((what, reached, found, reached - found, apart))
        progress.add(1)
    print(f"\n{args.ranks} rank(s), seed {args.seed}, written every {INTERVAL:g} s, a step {STEP:g} s; found at the "
          f"end with a disturbance of 1e-9: {min(reference[1].values()):.1g} to {max(reference[1].values()):.1g}\n\n"
          "| killed | in the step to [s] | continued from [s] | lost [s] | largest difference at the end |\n"
          "|---|---|---|---|---|")
    for what, reached, found, lost, apart in rows:
        figures = [f"{found:g}", f"{lost:.4f}", f"{apart:.1g}"] if found != "" else ["", "", ""]
        print("| " + " | ".join([what, f"{reached:g}", *figures]) + " |")
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
