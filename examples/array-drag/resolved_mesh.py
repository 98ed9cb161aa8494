# SPDX-License-Identifier: BSD-3-Clause
"""The flow through a cubic array of fixed spheres by OpenFOAM's simpleFoam, on a mesh that snappyHexMesh fits to them.

One cube of the array has the edge 1. Planes through sphere centres are planes of symmetry, so that a quarter of it is
computed, along the flow a mesh of an eighth and its mirror image: the two ends are the same faces."""

import json
import math
import re
import subprocess
from pathlib import Path

from cohesion_studies.case_entries import in_text
from cohesion_studies.foam_case import FoamCase
from cohesion_studies.job_pool import Job, RunError, dies_with_us, digest_of

HERE = Path(__file__).resolve().parent
CASE, MARK, SOLVER = HERE / "case", "settings.json", "simpleFoam"
MOST_ITERATIONS = 2000

# Sphere centres in an eighth of the cube, and how many spheres the cube has
CENTRES = {"sc": [(0, 0, 0)], "fcc": [(0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)]}
SPHERES = {"sc": 1, "fcc": 4}

# Of slow flow, which is without inertia to some Re^2
SLOW = 0.01


def diameter(kind, phi):
    """Of a sphere, in edges of the cube."""
    return (6 * phi / (math.pi * SPHERES[kind])) ** (1 / 3)


class MeshedFlow(Job):
    """`cells` to the edge of the cube, an even number; `re` = U d/nu, U superficial, 0: slow."""

    def __init__(self, folder, env, kind, phi, re_, cells):
        self.env, self.kind, self.phi, self.re, self.cells = env, kind, phi, re_ or SLOW, cells
        settings = {"kind": kind, "phi": phi, "re": self.re, "cells": cells, "case": digest_of(CASE.rglob("*"))}
        super().__init__(folder, settings, work=float(cells) ** 4, readers=digest_of([__file__]))

    def prepare(self):
        case = FoamCase(CASE, self.folder, self.env, overwrite=True)
        (self.folder / MARK).write_text(json.dumps(self.settings))
        size = diameter(self.kind, self.phi)
        (self.folder / "system/spheres").write_text("".join(
            f"sphere{i} {{ type searchableSphere; centre ({x} {y} {z}); radius {size / 2!r}; }}\n"
            for i, (x, y, z) in enumerate(CENTRES[self.kind])))
        case.edit("system/blockMeshDict", cells=self.cells // 2)
        case.edit("system/controlDict", endTime=MOST_ITERATIONS)
        for program in ("blockMesh", "snappyHexMesh -overwrite", "mirrorMesh -overwrite", "topoSet",
                        "createPatch -overwrite", "checkMesh"):
            case.run(*program.split())
        # The superficial velocity is 1
        case.edit("system/fvOptions", Ubar=f"({1 / self.fluid()!r} 0 0)")
        case.edit("constant/transportProperties", nu=repr(size / self.re))
        (self.folder / "0.orig").rename(self.folder / "0")

    def fluid(self):
        """Share of the cube that the mesh fills."""
        file = self.folder / "log.checkMesh"
        return 4 * float(in_text(r"Total volume = (\S+)\.\s", file, file.read_text(), "'Total volume'"))

    def start(self):
        self.prepare()
        with open(self.folder / f"log.{SOLVER}", "w") as log:
            return subprocess.Popen(dies_with_us([SOLVER]), cwd=self.folder, env=self.env, stdout=log, stderr=log,
                                    stdin=subprocess.DEVNULL)

    def share(self):
        """What is left is not known: half."""
        return 0.5

    def tail(self):
        return "\n".join((self.folder / f"log.{SOLVER}").read_text().splitlines()[-15:])

    def figures(self):
        """K = F_total/(3 pi mu d U), F_total the pressure gradient times the volume of the cube to a sphere."""
        log = (self.folder / f"log.{SOLVER}").read_text()
        if "SIMPLE solution converged" not in log:
            raise RunError(f"not steady after {MOST_ITERATIONS} iterations")
        gradient = float(re.findall(r"pressure gradient = (\S+)", log)[-1])
        size = diameter(self.kind, self.phi)
        return {"K": gradient / (SPHERES[self.kind] * 3 * math.pi * size * size / self.re),
                "phi_of_mesh": 1 - self.fluid(), "iterations": len(re.findall("(?m)^Time = ", log))}
