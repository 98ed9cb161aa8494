# SPDX-License-Identifier: BSD-3-Clause
"""Lets cohesive spheres stick to agglomerates in a gas that cools and in shear, measures the drag on some of those, on
chains and on dense balls, alone and among others, by array-drag, and ends in a law, a table, figures beside those
expected, and a picture. What is done is not done again.

    run.py [--build FOLDER] [--out FOLDER] [--together N] [--overwrite]
"""

import argparse
from pathlib import Path

import numpy as np

import law
import picture
import shapes
from cohesion_studies import expected, program
from cohesion_studies.drag_run import MARK, OFF_NODES, ArrayDrag, DragRun, radius_in_cube
from cohesion_studies.job_pool import RunError, carry_out, digest_of, require_ours
from cohesion_studies.lammps_run import NotBuilt, ScriptRun, launcher
from cohesion_studies.tool_program import ToolError

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected.csv"

# Variables of in.agglomerates
GAS = {"count": 2000, "phi": 0.02, "A": 0.024, "speed": 0.3, "rate": 0.0, "steps": 26667, "seed": 1}
SOURCES = {"cooling": {}, "shear": {"speed": 0.5, "rate": 0.02}}
WANTED = [3, 5, 8, 13, 20, 32, 50, 80, 120, 200, 320]

CHAINS = [1, 2, 3, 5, 10]
BALLS = [13, 43, 135, 321]

# Of those among others: fractions of solid, agglomerates to a cube, seeds.
SUSPENSIONS = {"ball-13": [0.03, 0.1, 0.16], "shear-13": [0.03, 0.1]}
TOGETHER, SEEDS, SPACINGS = 8, 2, 6

WIDEST = 47.0  # cube for one alone, [diameters]: 188 nodes along an edge, 1 GB; agglomerates that need more are left out


def spacings(edge):
    """To a diameter, in a cube of so many diameters: what fits into 80 nodes along its edge, from 4 to 10."""
    return min(10.0, max(4.0, 80 / edge))


class Sticking(ScriptRun):
    """One run of in.agglomerates."""

    def __init__(self, out, engine, name, changed):
        self.given = {**GAS, **changed}
        programs = digest_of([HERE / "in.agglomerates", engine[1]])
        super().__init__(out / name, HERE / "in.agglomerates", engine, {**self.given, "programs": programs})

    def variables(self):
        return self.given

    def figures(self):
        return {}

    def share(self):
        row = self.last_row(6)
        return row[0] / self.given["steps"] if row else 0.0


class BodyRun(DragRun):
    """array-drag of spheres in a cube, along the three axes."""

    def __init__(self, folder, tool, places, edge, diameter):
        self.rows = "".join(f"{x:.9g} {y:.9g} {z:.9g} 1\n" for x, y, z in places)
        super().__init__(folder, tool, ["--spheres", "spheres", "--box", *[f"{edge:.9g}"] * 3, "--diameter", diameter,
                                        "--tensor", "--tolerance", 1e-3], inputs=self.rows)
        self.work = edge**3 * diameter**3

    def prepare(self):
        (self.folder / "spheres").write_text(self.rows)


def cube_for(places):
    """Edge of the cube that an agglomerate alone is put into. [diameters]"""
    return max(8.0, 6 * np.sqrt(0.25 + shapes.radius_of_gyration(places)**2), 1.3 * np.ptp(places, axis=0).max() + 2)


class Alone(BodyRun):
    """One agglomerate in a cube seven times as wide as it is for the flow, or more."""

    def __init__(self, folder, tool, places):
        self.places = places - places.mean(axis=0)
        self.edge = cube_for(places)
        super().__init__(folder, tool, self.places + self.edge / 2 + OFF_NODES / spacings(self.edge), self.edge,
                         spacings(self.edge))

    def figures(self):
        found = super().figures()
        n = len(self.places)
        radii = [radius_in_cube(found[f"F_{k}{k}"] / (1 - found["phi"]), n, self.edge) for k in "xyz"]
        return {"n": n, "radii": radii, "radius": 3 / sum(1 / r for r in radii),
                "gyration": 2 * shapes.radius_of_gyration(self.places),
                "projected": [2 * r for r in shapes.projected_radii(self.places)], "seconds": found["seconds"]}


class Among(BodyRun):
    """Agglomerates of one kind at random in a cube."""

    def __init__(self, folder, tool, alone, phi, seed):
        self.alone = alone
        places, edge = shapes.suspension(alone.places, TOGETHER, phi, seed)
        super().__init__(folder, tool, places, edge, SPACINGS)

    def figures(self):
        found = super().figures()
        return {"F": float(np.mean([found[f"F_{k}{k}"] for k in "xyz"])), "own": found["F_beetstra"],
                "phi": found["phi"], "seconds": found["seconds"]}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/agglomerate-drag")
    program.together_words(parser)
    return parser.parse_args()


def bodies(out, sources):
    """Centres by name of all that is measured alone."""
    named = {f"chain-{n}": shapes.chain(n) for n in CHAINS} | {f"ball-{n}": shapes.ball(n) for n in BALLS}
    for source in sources:
        for places in shapes.found_in(out / source / "spheres.txt", WANTED):
            if cube_for(places) > WIDEST:
                print(f"run.py: {source}-{len(places)} is left out: wider than what is computed")
                continue
            named[f"{source}-{len(places)}"] = places
    return named


def main():
    args = arguments()
    expected.rows(EXPECTED)  # refused before anything is run
    out = program.out_folder(args, "agglomerate-drag").resolve()
    engine, tool = launcher(args.build), ArrayDrag(args.build)
    sticking = [Sticking(out, engine, name, changed) for name, changed in SOURCES.items()]
    require_ours(sticking, MARK, args.overwrite)
    carry_out(sticking, args.together)

    alone = {name: Alone(out / name, tool, places) for name, places in bodies(out, SOURCES).items()}
    among = {f"{name}-at-{phi}-seed-{seed}": Among(out / f"{name}-at-{phi}-seed-{seed}", tool, alone[name], phi, seed)
             for name, fractions in SUSPENSIONS.items() if name in alone
             for phi in fractions for seed in range(1, SEEDS + 1)}
    jobs = {**alone, **among}
    require_ours(jobs.values(), MARK, args.overwrite)
    results = dict(zip(jobs, carry_out(list(jobs.values()), args.together)))
    found = law.figures({name: results[name] for name in alone},
                        {name: {**results[name], "alone": results[job.alone.name]} for name, job in among.items()})
    program.leave_table(out, law.text(found) + "\n\n" + expected.text(EXPECTED, found))
    picture.draw(out / "result.png", found, {name: job.places for name, job in alone.items()})


if __name__ == "__main__":
    program.run(main, NotBuilt, ToolError, RunError, expected.ExpectationError)
