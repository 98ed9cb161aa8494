#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the exchange of gas and particles costs a rank as the problem grows with the ranks (growing_swarm.py).

    exchange_traffic.py BUILD WORK [--ranks N ...] [--steps N] [--kernel NAME] [--csv FILE]

Prints what each rank sent per gas step, counted by cohesiveBedFoam where it sends, mean and largest over the
ranks; and of 1 and 2 ranks, which have a core each, the time. More ranks than cores share them: their
messages are the same as on cores of their own, their times say nothing. Messages and ranks do not depend on
the number of steps; bytes do, as the spheres move. Ends with 1, and enters nothing, when the messages are not those
that follow from the neighbours of each rank alone."""

import sys

from cohesion_tests import csv_table, measuring_program
from cohesion_tests.coupling.cases import Columns
from cohesion_tests.coupling.growing_swarm import FORWARD, SPHERES, differing, run
from cohesion_tests.progress import Progress


def enter(file, ranks, counts):
    """Into coupled_speed.csv: bytes in hundreds."""
    names = {"messages": "messages of a rank", "bytes": "bytes", "to ranks": "to ranks"}
    text = {name: (f"{mean:.1f}", f"{largest:.0f}") for name, (mean, largest) in counts.items()}
    text["bytes"] = [csv_table.grouped(round(value, -2)) for value in counts["bytes"]]
    csv_table.enter_quantities(file, "messages per gas step",
                               f"{ranks} ranks, {csv_table.grouped(SPHERES * ranks)} spheres",
                               {f"{names[name]}, {which}": value for name, pair in text.items()
                                for which, value in zip(("mean", "largest"), pair)})


def main():
    parser = measuring_program.coupling_parser(__doc__, table=True)
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2, 4, 8, 16, 32, 64], metavar="N")
    parser.add_argument("--steps", type=int, default=3, metavar="N", help="gas steps (%(default)s)")
    parser.add_argument("--kernel", choices=FORWARD, default="sphereOverlap", help="of the void fraction (%(default)s)")
    args = parser.parse_args()
    csv_table.require_published(args, steps=3, kernel="sphereOverlap")
    progress, rows = Progress(sum(args.ranks)), {}
    for ranks in args.ranks:
        rows[ranks] = run(Columns(args.build, args.work), ranks, args.steps, args.kernel)
        progress.add(ranks)
    print("\n| ranks | spheres | messages, mean, largest | bytes, mean, largest | to ranks, mean, largest "
          "| exchange, all [ms] |\n|---|---|---|---|---|---|")
    for ranks, (counts, seconds, _) in rows.items():
        figures = [f"{mean:.1f}, {largest:.1f}" for mean, largest in counts.values()]
        times = f"{seconds[0]:.2f}, {seconds[1]:.1f}" if ranks <= 2 else ""
        print("| " + " | ".join([str(ranks), str(SPHERES * ranks), *figures, times]) + " |")
    wrong = [ranks for ranks, (counts, _, error) in rows.items()
             if error > 1e-12 or differing(counts, ranks, args.kernel)]
    if wrong:
        sys.exit(f"other messages than follow from neighbours, or no balance, on ranks: {wrong}")
    for ranks in sorted(rows.keys() - {1}):  # one rank sends nothing
        enter(args.csv, ranks, rows[ranks][0])


if __name__ == "__main__":
    main()
