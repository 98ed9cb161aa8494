#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time of a step of scheme exact over that of LAMMPS' gran/hooke/history, of gran/hertz/history for the laws hertz (with
a Hamaker attraction) and jkr, or with --law jkr --granular of LAMMPS' own jkr, on the same spheres.

  cost-per-step.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--turns N] [--steps N] [--scene NAME] [--instructions]
                   [--law hamaker | liquid_bridge | capillary | square_well | hertz | jkr] [--ratio RATIO] [--granular]
                   [--csv FILE]

Two scenes of 4000 equal spheres, t_c/20, restitution 0.9: a gas at solid fraction 0.55, and a packing
with six persistent contacts each. Both styles start from the same positions and velocities and run in
turns; each turn gives one ratio of LAMMPS' own loop times (processor seconds), so that a machine that
gets slower on the way does not decide. Printed: nanoseconds per particle and step, contacts per
particle at the end, median ratio, and the quarter and three quarter points of the ratios. With
--instructions: instructions per particle and step instead, of which one turn is enough.
"""
import re

import numpy

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.instruction_count import per_step
from cohesion_tests.thermo import processor_seconds, thermo_end

SCENES = ("gas", "packing")
# A [J], F_b [N], surface tension [N/m], D [J], A [J], surface energy [J/m2]
STRENGTHS = {"hamaker": 2e-18, "liquid_bridge": 1e-4, "capillary": 0.032, "square_well": 5e-11, "hertz": 2e-18,
             "jkr": 0.01}
# Of in.cost_per_step
STYLES = {"hamaker": "exact", "liquid_bridge": "bridge", "capillary": "capillary", "square_well": "well", "hertz": "hertz",
          "jkr": "jkr"}
# Of contact_costs.csv: style and strength of a law, and name of the other style.
NAMES = {"hamaker": ("gran/hamaker", "A = {:g} J"), "hertz": ("gran/hamaker normal hertz", "A = {:g} J"),
         "jkr": ("gran/jkr", "{:g} J/m2"), "liquid_bridge": ("gran/liquidbridge", "bridge"),
         "capillary": ("gran/liquidbridge", "capillary"), "square_well": ("gran/squarewell", "D = {:g} J")}
REFERENCES = {"stock": "gran/hooke/history", "stock_hertz": "gran/hertz/history", "stock_jkr": "granular with jkr"}


def table_row(law, scene, mu, constant, reference):
    style, strength = NAMES[law]
    strength = "none" if style == "gran/liquidbridge" and constant == 0 else strength.format(constant)
    return {"engine": "LAMMPS", "scene": scene, "style": style, "friction": f"{mu:g}", "strength": strength,
            "reference": REFERENCES[reference]}


def main():
    words = measuring_program.words(__doc__, ("--turns", {"type": int, "default": 11}),
                                    ("--steps", {"type": int, "default": 1000}),
                                    ("--scene", {"choices": SCENES, "action": "append"}),
                                    ("--law", {"choices": STRENGTHS, "default": "hamaker"}),
                                    ("--ratio", {"type": float, "default": 1.01, "help": "of the well"}),
                                    ("--granular", {"action": "store_true", "help": "with --law jkr"}),
                                    ("--instructions", {"action": "store_true"}), csv_table.OPTION)
    if words.csv and not words.instructions:
        raise SystemExit("--csv: with --instructions")
    csv_table.require_published(words, ratio=1.01)
    ours, strength = STYLES[words.law], STRENGTHS[words.law]
    stock = "stock_hertz" if words.law in ("hertz", "jkr") else "stock"
    if words.granular:
        if words.law != "jkr":
            raise SystemExit("--granular: LAMMPS' own jkr is compared with --law jkr only")
        stock = "stock_jkr"
    cases = ((0.0, 0.0), (0.3, 0.0), (0.0, strength), (0.3, strength))  # friction, strength
    if words.law == "jkr":
        cases = cases[2:]

    def cost(folder, scene, style, mu, constant):
        """Per particle and step: nanoseconds of a processor, or instructions; contacts per particle."""
        case = {"scene": scene, "make": "no", "style": style, "mu": mu, "A": constant,
                "ratio": words.ratio}
        output = engine.run("in.cost_per_step", folder, steps=words.steps, **case)
        contacts = thermo_end(output)["c_contacts"]
        atoms = int(re.search(r"Loop time of .* with (\d+) atoms", output)[1])
        if words.instructions:
            return per_step("in.cost_per_step", folder, words.steps, **case) / atoms, contacts
        return 1e9 * processor_seconds(output, 0) / (words.steps * atoms), contacts

    unit = "[1] " if words.instructions else "[ns]"
    print(f"scene    friction  strength   stock {unit}  contacts   exact {unit}  contacts   ratio")
    for scene in words.scene or SCENES:
        with engine.temporary_folder() as folder:
            engine.run("in.cost_per_step", folder, scene=scene, make="yes", style="stock", mu=0.3,
                       A=0.0, steps=500)
            for mu, constant in cases:
                turns = []
                for turn in range(1 if words.instructions else words.turns):
                    order = (stock, ours) if turn % 2 == 0 else (ours, stock)
                    done = {style: cost(folder, scene, style, mu, constant)
                            for style in order}
                    turns.append([*done[stock], *done[ours]])
                theirs, of_theirs, exact, of_exact = numpy.array(turns).T
                low, middle, high = numpy.percentile(exact / theirs, (25, 50, 75))
                print(f"{scene:8s}{mu:9g}{constant:10g}{numpy.median(theirs):13.1f}"
                      f"{of_theirs.mean():10.2f}{numpy.median(exact):13.1f}{of_exact.mean():10.2f}"
                      f"   {middle:.2f} ({low:.2f} to {high:.2f})", flush=True)
                found = {"instructions of the reference": f"{theirs[0]:.1f}", "instructions": f"{exact[0]:.1f}",
                         "ratio": f"{middle:.2f}"}
                csv_table.enter(words.csv, table_row(words.law, scene, mu, constant, stock), **found)


if __name__ == "__main__":
    main()
