# SPDX-License-Identifier: BSD-3-Clause
"""The beds that bubbles are measured in: those of bubbling-hard-sphere and fluidised-bed, at one velocity of the gas."""

import shutil
from pathlib import Path

import tracking
from cohesion_studies import case_entries, cavities, foam_results, package_tree
from cohesion_studies.bed import bed_case
from cohesion_studies.bed.bed_case import BedRun
from cohesion_studies.case_entries import entries
from cohesion_studies.case_job import CaseJob
from cohesion_studies.foam_results import read_cloud, written_times
from cohesion_studies.job_pool import digest_of

HARD_CASE = package_tree.EXAMPLES / "bubbling-hard-sphere/case"
START_UP = 0.8, 0.3  # s left out, hard and soft: until the plug that the sudden gas lifts has fallen back
CONTROL = "system/controlDict"
READERS = digest_of([__file__, *(m.__file__ for m in (tracking, case_entries, cavities, foam_results))])

# Superficial velocity of the gas and that of minimum fluidisation [m/s]: Ergun's for the resting void fraction of the
# hard bed (README of its example), and, within its error, where the rising branch of fluidised-bed meets the weight
# (its README: 0.730 +- 0.004 and 0.883 +- 0.003); what Darton et al. have for the plate, 4 sqrt(A_0) [m]: that of a
# porous one, and of a jet's share of the plate, 5.9 mm x 1 mm; the diameter of a sphere [m].
KINDS = {"hard": (2.4, 1.6, 0.03, 4e-3), "non-cohesive": (1.2, 0.727, 9.7e-3, 1e-3),
         "Hamaker": (1.2, 0.885, 9.7e-3, 1e-3)}
# Bed c, a little more than twice as wide: bubbles are then small beside it.
HARD = {"width": 0.31, "jetFrom": 0.15, "jetTo": 0.16, "middle": 0.155, "sideCells": 15, "count": 4960, "height": 0.8,
        "cellsUp": 40, "endTime": 3}
SOFT = {"non-cohesive": {"A": 0, "scheme": "sampled"}, "Hamaker": {"A": 7.49e-19}}
SOFT_TIME = 1.5  # s
INTERVAL = {"hard": 5e-3, "soft": 4.95e-3}  # of pictures: whole gas steps [s]


def read_lives(case, diameter, width, height, start):
    """Of the bubbles of a finished case: {"lives": [measured()], "pictures": their number}."""
    pictures, times = [], []
    for time, folder in sorted(written_times(case).items()):
        if time > start:
            share = tracking.solid_share(read_cloud(folder)[0][:, :2], diameter, width, height)
            cell = width / share.shape[1], height / share.shape[0]
            pictures.append(tracking.bubbles(share, cell, diameter))
            times.append(time)
    lives = [tracking.measured(life, times) for life in tracking.follow(pictures)]
    return {"lives": [life for life in lives if life], "pictures": len(times)}


class HardBubbles(CaseJob):
    kind = "hard"

    def __init__(self, out, env, mark, seed, changed=None):
        self.size = {**HARD, "jet": KINDS["hard"][0], "background": KINDS["hard"][0], **(changed or {})}
        super().__init__(out / f"hard-{seed}", "hard", env, {**self.size, "seed": seed, "fingerprint": mark}, [tracking],
                         HARD_CASE, work=self.size["endTime"] * self.size["count"])
        self.seed, self.readers = seed, READERS

    def change(self):
        shutil.copy(self.folder / "constant/bed.c", self.folder / "constant/bed")
        self.set_entries({"constant/bed": self.size, CONTROL: {"writeInterval": INTERVAL["hard"]},
                          "constant/couplingProperties": {"lammpsCoeffs/variables/seed": self.seed}})

    def figures(self):
        return read_lives(self.folder, *self.sizes(), min(START_UP[0], self.size["endTime"] / 4))

    def sizes(self):
        """Diameter of the spheres, width and height."""
        of = entries(self.folder / "constant/bed")
        return of["diameter"], of["width"], of["height"]


class SoftBubbles(BedRun):
    def __init__(self, out, env, mark, kind, seed, end=SOFT_TIME):
        self.kind, self.seed, self.end = kind, seed, end
        given = {"engine": "lammps", **SOFT[kind], "seed": seed}
        super().__init__(out / f"{kind}-{seed}", given, env, mark)
        self.settings.update(end=end, velocity=KINDS[kind][0], interval=INTERVAL["soft"])
        self.work, self.readers = (10 if given["A"] else 5) * end * 4000, READERS

    def start(self):
        self.case = bed_case.make_case(self.folder, self.given, self.env)
        velocity = KINDS[self.kind][0]
        (Path(self.folder) / "constant/schedule").write_text(
            f"superficialVelocity table\n(\n    (0 (0 {velocity} 0))\n    ({self.end:g} (0 {velocity} 0))\n);\n\n"
            f"endTime {self.end:g};\nmovementStart 0;\n")
        self.case.set(CONTROL, "writeInterval", INTERVAL["soft"])
        (Path(self.folder) / "case.foam").touch()
        return self.case.start()

    def figures(self):
        return read_lives(self.folder, *self.sizes(), min(START_UP[1], self.end / 4))

    def sizes(self):
        return KINDS[self.kind][3], 0.08, 0.2
