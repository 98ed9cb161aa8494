# SPDX-License-Identifier: BSD-3-Clause
"""How far a program that measures is: on the error output, for its tables go to the other."""
import sys

from cohesion_studies.progress_line import ProgressLine


class Progress:
    """What is done and how long the rest will take; `work` in any unit."""

    def __init__(self, work):
        self.work, self.done, self.line = work, 0.0, ProgressLine(sys.stderr)

    def add(self, work):
        self.done += work
        left = self.line.elapsed * max(self.work - self.done, 0.0) / self.done if self.done else None
        self.line.show(left, f"{100 * min(self.done / self.work, 1.0):3.0f} % done")
