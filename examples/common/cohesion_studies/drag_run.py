# SPDX-License-Identifier: BSD-3-Clause
"""Runs of array-drag, and what the drag on a body in a periodic cube says of the body alone."""

import csv
import json
import subprocess

import numpy as np
from scipy.optimize import brentq

from cohesion_studies.job_pool import Job, digest_of, dies_with_us
from cohesion_studies.tool_program import ToolProgram

MARK = "settings.json"  # in the folder of a run

# Centre of a body from a node, [spacings]: a sphere whose surface passes through nodes is smaller for the flow.
OFF_NODES = np.array([0.31, 0.17, 0.43])


def radius_in_cube(drag, spheres, edge):
    """Hydrodynamic radius of a body of so many spheres in an unbounded fluid, in radii of one: of a sphere with its drag.
    `drag`: K = F/(6 pi mu a U) of one of its spheres in the mean, in a cube of the edge `edge`, in diameters. A body of
    hydrodynamic radius R in a periodic cube of edge L has K_R = F/(6 pi mu R U), 1/K_R = 1 - 2.8373 R/L + (4 pi/3) (R/L)^3
    (H. Hasimoto, J. Fluid Mech. 5 (1959) 317), and R K_R is what is measured. What is left out is of the order (R/L)^6
    of a sphere, and for other bodies (R/L)^3 times what sets them apart from one."""
    measured = drag * spheres * 0.5 / edge  # R K_R/L

    def off(radius):
        return radius - measured * (1 - 2.8373 * radius + 4.18879 * radius**3)
    return brentq(off, 0, 0.4) * edge / 0.5


class ArrayDrag(ToolProgram):
    name = "array-drag"


class DragRun(Job):
    """array-drag with some words, whose result is what it prints. `inputs`: what files that the words name hold."""

    def __init__(self, folder, tool, words, slice_too=False, inputs=""):
        self.tool, self.words, self.slice_too = tool, list(map(str, words)), slice_too
        super().__init__(folder, {"words": self.words, "program": digest_of([tool.file]), "inputs": inputs},
                         readers=digest_of([__file__]))

    def prepare(self):
        """Files that the words name."""

    def start(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / MARK).write_text(json.dumps(self.settings))
        self.prepare()
        command = [self.tool.file, *self.words, "--threads", "1", "--csv"]
        if self.slice_too:
            command += ["--slice", "slice.csv"]
        with open(self.folder / "out", "w") as out, open(self.folder / "log", "w") as log:
            return subprocess.Popen(dies_with_us(command), cwd=self.folder, stdout=out, stderr=log,
                                    stdin=subprocess.DEVNULL)

    def figures(self):
        with open(self.folder / "out", newline="") as out:
            return {row["name"]: float(row["value"]) for row in csv.DictReader(out)}

    def share(self):
        """From "array-drag: 12 s, flow 3 of 10, ..."."""
        lines = (self.folder / "log").read_text().splitlines()
        if not lines:
            return 0.0
        flow, flows = lines[-1].split("flow ")[1].split(",")[0].split(" of ")
        return (int(flow) - 0.5) / int(flows)

    def tail(self):
        return "\n".join((self.folder / "log").read_text().splitlines()[-5:])
