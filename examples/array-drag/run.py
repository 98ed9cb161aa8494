# SPDX-License-Identifier: BSD-3-Clause
"""Measures the drag on fixed spheres by array-drag, for each row of a table of arrays and for two spheres that touch, as
many at a time as there are cores, and ends in a table beside the closures, figures beside those expected, and a
picture. Rows that are done are not done again.

    run.py [--table FILE] [--build FOLDER] [--out FOLDER] [--together N] [--overwrite]
"""

import argparse
from pathlib import Path

import picture
from cohesion_studies import expected, program, study_table
from cohesion_studies.drag_run import MARK, OFF_NODES, ArrayDrag, DragRun, radius_in_cube
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.tool_program import ToolError

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected.csv"

KNOWN = {"array": "random", "phi": 0.3, "counts": 54, "sizes": 1, "diameter": 16, "re": 0, "speed": 0.02, "arrays": 1}

# Two spheres that touch, of the diameter 1 in a cube of the edge PAIR_BOX, along the flow and across it.
PAIR_BOX, PAIR_DIAMETER = 10.0, 10
PAIRS = {"pair-along": (1, 0, 0), "pair-across": (0, 1, 0)}

# Zick and Homsy (1982), table 2, simple cubic: K.
ZICK_HOMSY = {0.000125: 1.096, 0.001: 1.212, 0.008: 1.525, 0.027: 2.008, 0.064: 2.810, 0.125: 4.292, 0.216: 7.442,
              0.343: 15.4, 0.45: 28.1, 0.5236: 42.1}


class PairRun(DragRun):
    """Two spheres that touch, along x."""

    def __init__(self, folder, tool, direction):
        super().__init__(folder, tool, ["--spheres", "spheres", "--box", *[PAIR_BOX] * 3, "--diameter", PAIR_DIAMETER,
                                        "--direction", *direction])

    def prepare(self):
        x, y, z = PAIR_BOX / 2 + OFF_NODES / PAIR_DIAMETER
        (self.folder / "spheres").write_text("".join(f"{x + side} {y} {z} 1\n" for side in (-0.5, 0.5)))

    def figures(self):
        """`over_alone`: the drag on one of the two in an unbounded fluid over that of a sphere alone."""
        found = super().figures()
        return {**found, "over_alone": radius_in_cube(found["K"], 2, PAIR_BOX) / 2}


def row_words(row):
    """The words of array-drag for a row of the table."""
    words = ["--array", row["array"], "--phi", row["phi"], "--diameter", row["diameter"]]
    if row["array"] == "random":
        words += ["--counts", *str(row["counts"]).split(), "--sizes", *str(row["sizes"]).split(),
                  "--arrays", row["arrays"]]
    if row["re"]:
        # What is left of the flow's start is far below what arrays differ by
        words += ["--re", row["re"], "--speed", row["speed"], "--tolerance", 1e-3, "--average", 10000]
    return words


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--table", type=Path, default=HERE / "arrays.csv", metavar="FILE",
                        help="rows of arrays (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace rows of other settings")
    program.folder_words(parser, "BUILD/array-drag")
    program.together_words(parser)
    return parser.parse_args()


def figures(name, row, result):
    """Report on a row: its drag, errors, and what references and closures say over it."""
    found = {key: result[key] for key in ("phi", "Re", "F", "F_error", "F_error_1", "F_error_2", "F_1", "F_2",
                                          "over_alone", "seconds") if key in result}
    if row and row["array"] == "sc":
        found["over_zick_homsy"] = result["K"] / ZICK_HOMSY[row["phi"]]
    if row and row["array"] == "random":
        if str(row["sizes"]) == "1":
            found["over_beetstra"] = result["F"] / result["F_beetstra"]
        for size in ("_1", "_2"):
            for law in ("carmanKozeny", "vanDerHoef"):
                if f"F_{law}{size}" in result:
                    found[f"over_{law}{size}"] = result[f"F{size}"] / result[f"F_{law}{size}"]
        if row["re"]:
            found.update({f"over_{law}": result["F"] / result[f"F_{law}"]
                          for law in ("hillKochLadd", "tenneti", "tang")})
    return found


def text(found):
    """A block for each row that has several figures of its own."""
    lines = []
    for name, row in found.items():
        lines.append(f"{name:24s}" + "  ".join(f"{key} {value:.4g}" for key, value in row.items()))
    return "\n".join(lines)


def main():
    args = arguments()
    expected.rows(EXPECTED)  # refused before anything is run
    out = program.out_folder(args, "array-drag").resolve()
    tool = ArrayDrag(args.build)
    table = study_table.read_table(args.table, KNOWN)
    jobs = {name: DragRun(out / name, tool, row_words(row), row["array"] == "random") for name, row in table.items()}
    jobs.update({name: PairRun(out / name, tool, direction) for name, direction in PAIRS.items()})
    require_ours(jobs.values(), MARK, args.overwrite)
    results = dict(zip(jobs, carry_out(list(jobs.values()), args.together)))
    found = {name: figures(name, table.get(name), result) for name, result in results.items()}
    program.leave_table(out, text(found) + "\n\n" + expected.text(EXPECTED, found))
    picture.draw(out / "result.png", table, results, out)


if __name__ == "__main__":
    program.run(main, ToolError, RunError, study_table.TableError, expected.ExpectationError)
