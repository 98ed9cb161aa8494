# SPDX-License-Identifier: BSD-3-Clause
"""Runs of an example, some at a time, each in its own folder. What is finished is not run again; what was
killed or failed is. A run is finished when its folder holds a result of the same settings.

Processes that a job starts must not outlive the pool, whatever ends it: see dies_with_us()."""

import hashlib
import json
import os
import resource
import time
from pathlib import Path

from cohesion_studies.progress_line import ProgressLine

POLL = 0.5  # s between looks at the runs
RESULT = "result.json"  # of a finished run, in its folder
UNREAD = "unread"  # true in the result of a run whose figures have not been read


class RunError(RuntimeError):
    """A run could not be started or ended with an error; the text ends with the last lines of its log."""


def dies_with_us(command):
    """The command (list) of a process that the kernel ends together with this one, even by signal 9: a
    run that goes on alone would write into the folder of the one that replaces it."""
    return ["setpriv", "--pdeathsig", "KILL", *map(str, command)]


def cores():
    """That this process may use."""
    return len(os.sched_getaffinity(0))


def digest_of(files):
    """Of the names and contents of `files`, those of them that are files: tells when one has changed."""
    digest = hashlib.sha256()
    for file in sorted(Path(f) for f in files):
        if file.is_file():
            digest.update(file.name.encode() + file.read_bytes())
    return digest.hexdigest()


class Job:
    """One run. `settings`: all that it depends on, as JSON keeps it; `work`: how long it takes, in any unit that the
    jobs of a pool share; `readers`: what its figures depend on besides, digest_of() the programs that read them: with
    others the figures are read again, and the run is not made again. To be defined by a kind of run: start(),
    figures(), share()."""

    process = None
    processor_seconds = None  # of the process, once it has ended

    def __init__(self, folder, settings, work=1.0, readers=None):
        self.folder, self.settings, self.work, self.readers = Path(folder), settings, work, readers

    @property
    def name(self):
        return self.folder.name

    def kept(self):
        """What finish() has kept of a run of these settings; None before."""
        file = self.folder / RESULT
        found = json.loads(file.read_text()) if file.exists() else {}
        return found if found.get("settings") == self.settings else None

    def finished(self):
        return self.kept() is not None

    def result(self):
        """Of the finished run: the dict of figures() with settings and times; None before, and when other programs
        have read the figures, or none could."""
        found = self.kept()
        return found if found and found.get("readers") == self.readers and not found.get(UNREAD) else None

    def discard(self):
        """Takes the result away, if there is one."""
        (self.folder / RESULT).unlink(missing_ok=True)

    def launch(self):
        self.discard()
        self.begin = time.time()
        self.process = self.start()

    def finish(self):
        """After the process has ended: keeps the result, of a run that ended well even when its figures cannot be read.
        False when it has to be started once more. Raises RunError when it failed, or has no figures."""
        if self.process.returncode != 0:
            if self.again():
                return False
            raise RunError(f"{self.name}, in {self.folder}, failed:\n{readable(self.tail, 'no log')}")
        times = {"seconds": time.time() - self.begin, "processor_seconds": self.processor_seconds}
        self.keep({"settings": self.settings, "readers": None, UNREAD: True, **times})
        self.read_again()
        return True

    def read_again(self):
        """The figures of a finished run, which other programs have read, or none. Raises RunError."""
        kept = self.kept()
        try:
            figures = self.figures()
        except Exception as error:  # of whatever kind: the other runs go on
            raise RunError(f"{self.name}, in {self.folder}: its figures cannot be read: {error!r}; the next start "
                           "reads them again, and makes the run again once its folder is removed")
        times = {name: kept[name] for name in ("seconds", "processor_seconds")}
        self.keep({"settings": self.settings, "readers": self.readers, **times, **figures})

    def keep(self, result):
        """In place of the one before, whole or not at all."""
        scratch = self.folder / "result.new"
        scratch.write_text(json.dumps(result, indent=1))
        scratch.replace(self.folder / RESULT)

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


def require_ours(jobs, mark, overwrite=False):
    """Raises RunError when a folder of a job holds something that no start has left: what lacks the file `mark`; or,
    without `overwrite`, the results of other settings. What is not finished may be made anew."""
    for job in jobs:
        if not job.folder.exists() or job.finished() or not any(job.folder.iterdir()):
            continue
        if not (job.folder / mark).exists():
            raise RunError(f"'{job.folder}' holds something else than a run of this program, which would be lost: "
                           "move it, or give --out for another folder")
        if (job.folder / RESULT).exists() and not overwrite:
            raise RunError(f"'{job.folder}' holds the results of other settings: give --overwrite to replace them, "
                           "or --out for another folder")


def readable(look, otherwise):
    """What `look`, share() or tail() of a job, finds, `otherwise` while the file it reads is not there."""
    try:
        return look()
    except OSError:
        return otherwise


def processor_seconds_of_children():
    """That have ended and were waited for."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def ended(job):
    """Whether a running job is done with; a job that goes on once more is not. Raises RunError."""
    before = processor_seconds_of_children()
    if job.process.poll() is None:
        return False
    job.processor_seconds = processor_seconds_of_children() - before
    if job.finish():
        return True
    job.launch()
    return False


def carry_out(jobs, together):
    """Makes all jobs that have no result yet, `together` at a time, the longest first; gives the results
    of all. A job that fails does not stop the others: RunError in the end, with all failures."""
    waiting = sorted((job for job in jobs if not job.finished()), key=lambda job: job.work)
    if len(waiting) < len(jobs):
        print(f"    {len(jobs) - len(waiting)} of {len(jobs)} runs are done: taking their results")
    all_work, done, running, failed = sum(job.work for job in waiting), 0.0, [], {}
    to_read = [job for job in jobs if job.finished() and job.result() is None]
    if to_read:
        print(f"    what reads their figures has changed, or could not: reading those of {len(to_read)} again")
    line = ProgressLine()

    def over(job, step):
        """Whether the job is done with after `step` of it, by itself or because it failed."""
        try:
            return step(job)
        except (RunError, OSError) as error:
            failed[job] = str(error) if isinstance(error, RunError) else f"{job.name}, in {job.folder}: {error}"
            return True

    for job in to_read:
        over(job, Job.read_again)
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
            line.show(left, f"{100 * so_far / all_work:3.0f} %, {len(waiting)} of {len(jobs)} runs wait, running "
                            + ", ".join(job.name for job in running))
    finally:
        for job in running:
            if job.process:
                job.process.terminate()
        line.close()
    if failed:
        raise RunError("\n".join([*failed.values(), f"{len(failed)} of {len(jobs)} runs failed"]))
    return [job.result() for job in jobs]
