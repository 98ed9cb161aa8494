# SPDX-License-Identifier: BSD-3-Clause
"""The drag on cubic arrays by array-drag beside that of a second solver, OpenFOAM's simpleFoam on meshes fitted to the
spheres: face-centred cubic arrays in slow flow and with inertia, and a simple cubic one whose drag is known, as many runs
at a time as there are cores. Runs that are done are not done again.

    beside_openfoam.py [--rows NAME ...] [--cells N N] [--diameter N] [--out FOLDER] [--build FOLDER] [--together N]
                       [--overwrite]
"""

import argparse
from pathlib import Path

from cohesion_studies import expected, program
from cohesion_studies.drag_run import MARK, ArrayDrag, DragRun
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.tool_program import ToolError
from resolved_mesh import MeshedFlow

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected_openfoam.csv"

# Array, fraction of solid, Re
ROWS = {"sc-0.216": ("sc", 0.216, 0), "fcc-0.2": ("fcc", 0.2, 0), "fcc-0.45": ("fcc", 0.45, 0),
        "fcc-0.2-re-20": ("fcc", 0.2, 20)}

# Zick and Homsy (1982), table 2
ZICK_HOMSY = {"sc-0.216": 7.442}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--rows", nargs="+", choices=ROWS, default=list(ROWS), metavar="NAME", help=", ".join(ROWS))
    parser.add_argument("--cells", nargs=2, type=int, default=[48, 64], metavar="N",
                        help="to the edge of a cube of the array, even numbers, the coarse mesh first (%(default)s)")
    parser.add_argument("--diameter", type=int, default=24, metavar="N",
                        help="of array-drag, in spacings; two thirds of it besides, for its error (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/array-drag-beside-openfoam")
    program.together_words(parser)
    args = parser.parse_args()
    if not 8 <= args.cells[0] < args.cells[1] or any(cells % 2 for cells in args.cells):
        parser.error(f"--cells {args.cells[0]} {args.cells[1]}: two even numbers from 8 on, the smaller one first")
    return args


def without_cells(coarse, fine, cells):
    """K of cells without size, by two meshes whose error falls with the square of a cell, and its error: half of what is
    added to the fine mesh's K, as it is between the orders 1.5 and 3 for meshes 4:3 or 3:2."""
    added = (fine - coarse) / ((cells[1] / cells[0]) ** 2 - 1)
    return fine + added, 0.5 * abs(added)


def without_spacings(coarse, fine):
    """K of array-drag and its error: what half as many spacings again change."""
    return fine, abs(fine - coarse)


def figures(name, runs, cells):
    """`runs`: results of the coarse and the fine mesh, the coarse and the fine array-drag."""
    mesh, mesh_error = without_cells(runs[0]["K"], runs[1]["K"], cells)
    lattice, lattice_error = without_spacings(runs[2]["K"], runs[3]["K"])
    both = (mesh_error + lattice_error) / mesh
    found = {"K_openfoam": mesh, "error_openfoam": mesh_error / mesh, "K_array_drag": lattice,
             "error_array_drag": lattice_error / mesh, "over_openfoam": lattice / mesh,
             "difference_over_errors": abs(lattice / mesh - 1) / both, "Re": runs[3]["Re"],
             "seconds": sum(run["seconds"] for run in runs)}
    if name in ZICK_HOMSY:
        found["openfoam_over_zick_homsy"] = mesh / ZICK_HOMSY[name]
        found["off_zick_homsy_over_error"] = abs(mesh - ZICK_HOMSY[name]) / mesh_error
    return found


def jobs_of(out, env, tool, row, cells, diameter):
    kind, phi, re = ROWS[row]
    words = ["--array", kind, "--phi", phi, "--tolerance", 1e-6] + (["--re", re] if re else [])
    return ([MeshedFlow(out / f"{row}-cells-{n}", env, kind, phi, re, n) for n in cells]
            + [DragRun(out / f"{row}-spacings-{n}", tool, [*words, "--diameter", n])
               for n in (round(diameter / 1.5), diameter)])


def main():
    args = arguments()
    expected.rows(EXPECTED)
    out = program.out_folder(args, "array-drag-beside-openfoam").resolve()
    env, tool = environment(args.build), ArrayDrag(args.build)
    jobs = {row: jobs_of(out, env, tool, row, args.cells, args.diameter) for row in args.rows}
    every = [job for row in jobs.values() for job in row]
    require_ours(every, MARK, args.overwrite)
    results = dict(zip(every, carry_out(every, args.together)))
    found = {row: figures(row, [results[job] for job in jobs[row]], args.cells) for row in jobs}
    text = "\n".join(f"{row:14s}" + "  ".join(f"{key} {value:.5g}" for key, value in numbers.items())
                     for row, numbers in found.items())
    program.leave_table(out, text + "\n\n" + expected.text(EXPECTED, found))


if __name__ == "__main__":
    program.run(main, ToolError, RunError, expected.ExpectationError)
