# SPDX-License-Identifier: BSD-3-Clause
"""How far a long program is, on the screen."""
import sys
import time


class Progress:
    """What is done and how long the rest will take; `work` in any unit."""

    def __init__(self, work):
        self.work, self.done, self.start = work, 0.0, time.time()

    def add(self, work):
        self.done += work
        if not self.done:
            return  # how long work takes is not known before some is done
        used = time.time() - self.start
        left = used * max(self.work - self.done, 0.0) / self.done
        print(f"\r{100 * min(self.done / self.work, 1.0):3.0f} % done, about {left:.0f} s left   ",
              end="", file=sys.stderr, flush=True)
