# SPDX-License-Identifier: BSD-3-Clause
"""Runs of an example, some at a time, each in its own folder. What is finished is not run again; what was
killed or failed is. A run is finished when its folder holds a result of the same settings.

Processes that a job starts must not outlive the pool, whatever ends it: see dies_with_us()."""

import json
import os
import time
from pathlib import Path

from progress_line import ProgressLine

POLL = 0.5  # s between looks at the runs


class RunError(RuntimeError):
    """A run could not be started or ended with an error; the text ends with the last lines of its log."""


def dies_with_us(command):
    """The command (list) of a process that the kernel ends together with this one, even by signal 9: a
    run that goes on alone would write into the folder of the one that replaces it."""
    return ["setpriv", "--pdeathsig", "KILL", *map(str, command)]


def cores():
    """That this process may use."""
    return len(os.sched_getaffinity(0))


class Job:
    """One run. `settings`: all that its result depends on, as JSON keeps it; `work`: how long it takes, in
    any unit that the jobs of a pool share. To be defined by a kind of run: start(), figures(), share()."""

    process = None

    def __init__(self, folder, settings, work=1.0):
        self.folder, self.settings, self.work = Path(folder), settings, work

    @property
    def name(self):
        return self.folder.name

    def result(self):
        """Of the finished run: the dict of figures() with settings and seconds; None before."""
        file = self.folder / "result.json"
        found = json.loads(file.read_text()) if file.exists() else {}
        return found if found.get("settings") == self.settings else None

    def discard(self):
        """Takes the result away, if there is one."""
        (self.folder / "result.json").unlink(missing_ok=True)

    def launch(self):
        self.discard()
        self.begin = time.time()
        self.process = self.start()

    def finish(self):
        """After the process has ended: keeps the result. False when it has to be started once more.
        Raises RunError when it failed."""
        if self.process.returncode != 0:
            if self.again():
                return False
            raise RunError(f"{self.name}, in {self.folder}, failed:\n{readable(self.tail, 'no log')}")
        seconds = time.time() - self.begin
        try:
            figures = self.figures()
        except Exception as error:  # of whatever kind: the other runs go on
            raise RunError(f"{self.name}, in {self.folder}: its figures cannot be read: {error!r}")
        result = {"settings": self.settings, "seconds": seconds, **figures}
        scratch = self.folder / "result.new"
        scratch.write_text(json.dumps(result, indent=1))
        scratch.replace(self.folder / "result.json")
        return True

    def start(self):
        """Starts the run afresh, whatever its folder holds; gives its process (Popen). RunError when it
        cannot be started."""
        raise NotImplementedError

    def figures(self):
        """Of the run that has just ended well, a dict for JSON."""
        raise NotImplementedError

    def share(self):
        """Done so far [1]."""
        raise NotImplementedError

    def again(self):
        """Whether a run that failed is to be started once more, changed by this."""
        return False

    def tail(self):
        """Last lines of the log of a run that failed."""
        return ""


def readable(look, otherwise):
    """What `look`, share() or tail() of a job, finds, `otherwise` while the file it reads is not there."""
    try:
        return look()
    except OSError:
        return otherwise


def ended(job):
    """Whether a running job is done with; a job that goes on once more is not. Raises RunError."""
    if job.process.poll() is None:
        return False
    if job.finish():
        return True
    job.launch()
    return False


def carry_out(jobs, together):
    """Makes all jobs that have no result yet, `together` at a time, the longest first; gives the results
    of all. A job that fails does not stop the others: RunError in the end, with all failures."""
    waiting = sorted((job for job in jobs if job.result() is None), key=lambda job: job.work)
    if len(waiting) < len(jobs):
        print(f"    {len(jobs) - len(waiting)} of {len(jobs)} runs are done: taking their results")
    all_work, done, running, failed = sum(job.work for job in waiting), 0.0, [], {}
    line = ProgressLine()

    def over(job, step):
        """Whether the job is done with after `step` of it, by itself or because it failed."""
        try:
            return step(job)
        except (RunError, OSError) as error:
            failed[job] = str(error) if isinstance(error, RunError) else f"{job.name}, in {job.folder}: {error}"
            return True

    try:
        while waiting or running:
            while waiting and len(running) < together:
                running.append(waiting.pop())
                over(running[-1], Job.launch)
            time.sleep(POLL)
            for job in list(running):
                if job in failed or over(job, ended):
                    running.remove(job)
                    done += job.work
            so_far = done + sum(job.work * readable(job.share, 0.0) for job in running)
            left = line.elapsed * (all_work - so_far) / so_far if line.elapsed > 5 and so_far else None
            line.show(left, f"{100 * so_far / all_work:3.0f} %, running "
                            + ", ".join(job.name for job in running))
    finally:
        for job in running:
            if job.process:
                job.process.terminate()
        line.close()
    if failed:
        raise RunError("\n".join([*failed.values(), f"{len(failed)} of {len(jobs)} runs failed"]))
    return [job.result() for job in jobs]
