# SPDX-License-Identifier: BSD-3-Clause
"""One line that says how far a job is: rewritten on a terminal, seldom repeated elsewhere."""

import sys
import time

REPORT = 20.0  # s between lines when the output is not a terminal


def clock(seconds):
    return f"{int(seconds) // 60}:{int(seconds) % 60:02d}"


class ProgressLine:
    def __init__(self, stream=None):
        """stream: where it is shown, the output of the program when not given."""
        self.begin = self.last = time.time()
        self.stream = stream or sys.stdout
        self.on_terminal = self.stream.isatty()

    @property
    def elapsed(self):
        """s since the beginning."""
        return time.time() - self.begin

    def show(self, left, text):
        """left: s, or None when not known yet."""
        line = (f"    {clock(self.elapsed)} elapsed, "
                + (f"about {clock(left)} left" if left is not None else "time left not known yet")
                + ": " + text)
        if self.on_terminal:
            print("\r" + line.ljust(79), end="", file=self.stream, flush=True)
        elif time.time() - self.last > REPORT:
            self.last = time.time()
            print(line, file=self.stream, flush=True)

    def close(self):
        if self.on_terminal:
            print(file=self.stream)
