# SPDX-License-Identifier: BSD-3-Clause
"""Square wells and Hamaker attractions that hold head-on pairs up to the same speed: the thesis's
table, depth against Hamaker constant for other particles, and what scheme sampled makes of them.

    run.py [--out FOLDER] [--build FOLDER]
"""

import argparse
import csv

import numpy as np

import picture
from cohesion_studies import program
from cohesion_studies.mapping_program import MappingError, MappingProgram

# The bed of the thesis: spheres of 1 mm and 2650 kg/m3, its spring, dashpot and step.
RADIUS, DENSITY, STIFFNESS, RESTITUTION = 5e-4, 2650.0, 800.0, 0.948682
CUTOFF = (4e-10, 1e-7)
CONTACT_TIME = 9.2528e-5  # [s]
THESIS_STEP = 2.25e-5  # [s]
DEPTHS = (1e-11, 5e-11, 1e-10)  # [J]
BOTH_SAMPLED = ("--hamaker-scheme", "sampled", "--well-scheme", "sampled")

CONSTANTS = np.geomspace(1e-21, 1e-17, 25)  # [J]
# Of each family, what differs from the bed.
FAMILIES = {
    "radius [m]": [("5e-05", {"radius": 5e-5}), ("2e-04", {"radius": 2e-4}), ("5e-04", {}),
                   ("2e-03", {"radius": 2e-3})],
    "stiffness [N/m]": [("80", {"stiffness": 80}), ("800", {}), ("8e+03", {"stiffness": 8e3}),
                        ("8e+05", {"stiffness": 8e5})],
    "restitution": [("0.5", {"restitution": 0.5}), ("0.8", {"restitution": 0.8}), ("0.949", {}),
                    ("0.99", {"restitution": 0.99})],
}
STEPS = CONTACT_TIME / np.geomspace(3, 100, 22)  # [s]


class Program(MappingProgram):
    """cohesion-mapping for the spheres of the bed, and what differs from them."""

    def table(self, way, values, *more, radius=RADIUS, stiffness=STIFFNESS, restitution=RESTITUTION):
        return super().table(way, values, "--radius", radius, "--density", DENSITY, "--stiffness", stiffness,
                             "--restitution", restitution, "--cutoff", *CUTOFF, *more)


def thesis_table(program):
    """For each depth: the exact row; the same Hamaker constant sampled at the thesis's step; both laws
    sampled there, with the constant that restores the well's mean."""
    exact = program.table("to-hamaker", DEPTHS)
    at_step = ("--step", THESIS_STEP)
    same = program.table("to-well", [repr(row["hamaker_constant"]) for row in exact],
                         "--hamaker-scheme", "sampled", *at_step)
    return exact, same, program.table("to-hamaker", DEPTHS, *BOTH_SAMPLED, *at_step)


def curves(program):
    """By family and label: depths at CONSTANTS [J]."""
    return {family: {label: [row["depth"] for row in program.table("to-well", CONSTANTS, **changed)]
                     for label, changed in members}
            for family, members in FAMILIES.items()}


def over_steps(program):
    """What the mapping that is right at any step becomes with scheme sampled: for each of STEPS the row
    of both laws, and the exact escape velocity."""
    exact, = program.table("to-hamaker", DEPTHS[1:2])
    rows = []
    for step in STEPS:
        hamaker, = program.table("to-well", [exact["hamaker_constant"]], "--hamaker-scheme", "sampled",
                                 "--step", step)
        well, = program.table("to-hamaker", DEPTHS[1:2], "--well-scheme", "sampled", "--step", step)
        rows.append({**hamaker, **{k: v for k, v in well.items() if k.startswith("well_")}})
    return rows, exact["hamaker_mean"]


def text(exact, same, restored):
    """The thesis's table."""
    lines = [f"exact                                sampled at {THESIS_STEP:g} s, mean and range over v_esc",
             "D [J]    v_esc [m/s]   A [J]        well                   Hamaker, same A"
             "        A of the well's mean [J]"]
    for e, s, r in zip(exact, same, restored):
        def over(row, law):
            mean, low, high = (row[f"{law}_{k}"] / e["hamaker_mean"]
                               for k in ("mean", "slowest_parted", "fastest_stuck"))
            return f"{mean:.3f} ({low:.2f} to {high:.2f})"

        lines.append(f"{e['depth']:<8g} {e['hamaker_mean']:<13.4g} {e['hamaker_constant']:<12.4g} "
                     f"{over(r, 'well')}   {over(s, 'hamaker')}   {r['hamaker_constant']:.3g}")
    return "\n".join(lines)


def write_csv(file, families):
    with open(file, "w", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(["family", "value", "hamaker_constant", "depth"])
        for family, members in families.items():
            for label, depths in members.items():
                writer.writerows([family, label, f"{a:.6g}", f"{d:.6g}"]
                                 for a, d in zip(CONSTANTS, depths))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    program.folder_words(parser, "BUILD/cohesion-mapping", "results")
    args = parser.parse_args()
    out = program.out_folder(args, "cohesion-mapping").resolve()
    out.mkdir(parents=True, exist_ok=True)
    mapping = Program(args.build)
    program.leave_table(out, text(*thesis_table(mapping)))
    families = curves(mapping)
    write_csv(out / "depth.csv", families)
    print(f"curves:  {out / 'depth.csv'}")
    picture.draw(out / "result.png", CONSTANTS, families, STEPS / CONTACT_TIME, *over_steps(mapping))


if __name__ == "__main__":
    program.run(main, MappingError)
