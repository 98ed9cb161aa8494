# SPDX-License-Identifier: BSD-3-Clause
"""Runs the sheared discs with square wells, two runs at a time, and ends in a table of findings and a
picture. Runs that are finished are not run again.

    run.py [--full] [--out FOLDER] [--build FOLDER]
"""

import argparse
import functools
import hashlib
import json
import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))

import analyse  # noqa: E402
import picture  # noqa: E402
import sweep  # noqa: E402
from lammps_run import NotBuilt, launcher  # noqa: E402
from progress_line import ProgressLine  # noqa: E402

POLL = 0.5  # s between looks at the runs
TOO_FAR = "could miss a partner"  # the engine: particles fly too far in a step


class RunError(RuntimeError):
    """A run ended with an error; the text ends with the last lines of its log."""


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--full", action="store_true",
                        help="the whole sweep with the thesis's block rule (hours) instead of the subset")
    parser.add_argument("--out", type=Path, default=None,
                        help="folder for runs and results (BUILD/shear, with --full BUILD/shear-full)")
    parser.add_argument("--build", type=Path, default=HERE.parents[1] / "build",
                        help="build folder of the package")
    parser.add_argument("--together", type=int, default=2, metavar="N",
                        help="runs at a time (%(default)s)")
    args = parser.parse_args()
    if args.together < 1:
        parser.error(f"--together {args.together}: it must be 1 or more")
    return args


def discs(fraction, side):
    return round(fraction * side**2 / math.pi)


def step(run):
    """A fifteenth of the mean free time at the temperature of the run, which goes roughly as that of a
    dilute gas, 0.3/((1 - e^2) phi^2); deep wells make faster clusters."""
    contact = (1 - 7 * run.phi / 16) / (1 - run.phi)**2
    path = math.pi / (4 * math.sqrt(2) * run.phi * contact)
    speed = math.sqrt(math.pi / 2 * (0.3 / ((1 - run.e**2) * run.phi**2) + run.D))
    return path / speed / 15


@functools.lru_cache(maxsize=None)
def content(file):
    """What a result of other content was not made with."""
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()


class Job:
    """One run: its folder, its settings, its process."""

    def __init__(self, run, rule, out, engine):
        self.engine = engine
        self.folder = out / "runs" / run.name
        self.settings = {**run._asdict(), **rule._asdict(), "count": discs(run.phi, rule.side),
                         "dt": step(run), "skin": 4 if run.phi < 0.25 else 2.5,
                         "script": content(HERE / "in.shear"), "package": content(engine[1])}
        self.dt, self.tries, self.process = self.settings["dt"], 0, None  # dt: halved where it is too long
        self.most_progress = rule.start + rule.most * rule.block
        # Collisions, and how long they take: wells add events, and close clusters collide as they like.
        self.work = self.settings["count"] * (1 if run.D == 0 else 2)

    def result(self):
        """The finished run's numbers, or None."""
        file = self.folder / "result.json"
        found = json.loads(file.read_text()) if file.exists() else {}
        return found if found.get("settings") == self.settings else None

    def start(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        self.begin = time.time()
        program, plugin = self.engine
        command = [program, "-in", HERE / "in.shear", "-log", "none", "-var", "plugin", plugin,
                   "-var", "dt", f"{self.dt:.6g}", "-var", "skin", str(self.settings["skin"])]
        for name in ("count", "phi", "e", "D", "w", "seed", "start", "block", "most"):
            command += ["-var", name, str(self.settings[name])]
        with open(self.folder / "log", "w") as log:
            self.process = subprocess.Popen([str(word) for word in command], cwd=self.folder, stdout=log,
                                            stderr=log, stdin=subprocess.DEVNULL,
                                            env={**os.environ, "OMP_NUM_THREADS": "1"})

    def finish(self):
        """After the process has ended. False when it has to be started once more."""
        text = (self.folder / "log").read_text()
        if self.process.returncode != 0 and TOO_FAR in text and self.tries < 5:
            self.tries += 1
            self.dt /= 2
            return False
        if self.process.returncode != 0:
            raise RunError(f"LAMMPS failed in {self.folder}:\n" + "\n".join(text.splitlines()[-15:]))
        result = {"settings": self.settings, "dt": self.dt, "seconds": time.time() - self.begin,
                  **analyse.read_log(text)}
        scratch = self.folder / "result.new"
        scratch.write_text(json.dumps(result, indent=1))
        scratch.replace(self.folder / "result.json")
        return True

    def share(self):
        """Of the longest that the run can be, done so far [1]."""
        try:
            lines = (self.folder / "log").read_text().splitlines()
        except FileNotFoundError:
            return 0.0
        rows = [words for words in map(str.split, lines[-4:]) if len(words) == 6 and words[0].isdigit()]
        return min(float(rows[-1][2]) / self.most_progress, 1.0) if rows else 0.0


def carry_out(jobs, together):
    """All jobs that have no result yet, some at a time, the longest first."""
    waiting = sorted((job for job in jobs if job.result() is None), key=lambda job: job.work)
    if len(waiting) < len(jobs):
        print(f"    {len(jobs) - len(waiting)} of {len(jobs)} runs are done: taking their results")
    all_work, done, running, line = sum(job.work for job in waiting), 0.0, [], ProgressLine()
    try:
        while waiting or running:
            while waiting and len(running) < together:
                running.append(waiting.pop())
                running[-1].start()
            time.sleep(POLL)
            for job in [job for job in running if job.process.poll() is not None]:
                running.remove(job)
                if job.finish():
                    done += job.work
                else:
                    waiting.append(job)
            so_far = done + sum(job.work * job.share() for job in running)
            left = line.elapsed * (all_work - so_far) / so_far if line.elapsed > 5 and so_far else None
            line.show(left, f"{100 * so_far / all_work:3.0f} %, running "
                            + ", ".join(job.folder.name for job in running))
    finally:
        for job in running:
            job.process.terminate()
        line.close()
    return [job.result() for job in jobs]


def main():
    args = arguments()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("run.py: ended"))  # takes its runs along
    args.build = args.build.resolve()
    out = (args.out or args.build / ("shear-full" if args.full else "shear")).resolve()
    runs, rule = (sweep.full(), sweep.THESIS) if args.full else (sweep.subset(), sweep.SHORT)
    engine = launcher(args.build)
    results = carry_out([Job(run, rule, out, engine) for run in runs], args.together)
    text = analyse.report(results)
    (out / "result.txt").write_text(text + "\n")
    picture.draw(out, results)
    print(text)
    print(f"\npicture: {out / 'result.png'}\ntable:   {out / 'result.txt'}")


if __name__ == "__main__":
    try:
        main()
    except (NotBuilt, RunError) as error:
        sys.exit(f"run.py: {error}")
