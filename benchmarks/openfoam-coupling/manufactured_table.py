#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of the manufactured solution (manufactured_solution.py) on meshes and in steps, a line each.

    manufactured_table.py BUILD WORK [--csv FILE]"""

from cohesion_tests import csv_table, measuring_program
from cohesion_tests.coupling.cases import Columns
from cohesion_tests.coupling.manufactured_solution import in_space, in_time, orders

MESHES = (8, 16, 32, 64, 128)
STEPS = [0.16 / k for k in (4, 8, 16, 32, 64, 128)]

QUANTITY = "error of the gas velocity [m/s], manufactured solution, void fractions 0.55 to 0.85"


def main():
    parser = measuring_program.coupling_parser(__doc__, table=True)
    args = parser.parse_args()
    column = Columns(args.build, args.work)
    rows = in_space(column, MESHES)
    for n, velocity, pressure in rows:
        print(f"{n:4} cells along the edge: U off by {velocity:.3e} m/s, p by {pressure:.3e} m2/s2", flush=True)
        csv_table.enter(args.csv, {"quantity": QUANTITY, "case": f"{n} cells", "closed form": "0"},
                        computed=csv_table.power(velocity, 2))
    apart = in_time(column, STEPS)
    for dt, difference in zip(STEPS, apart):
        print(f"step {dt:.5f} s: U differs by {difference:.3e} m/s from that of half the step")
    in_u, in_p = (orders([row[k] for row in rows]) for k in (1, 2))
    print("orders in space: U", in_u, "p", in_p, "in time", orders(apart))


if __name__ == "__main__":
    main()
