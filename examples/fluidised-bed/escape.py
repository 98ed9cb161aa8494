# SPDX-License-Identifier: BSD-3-Clause
"""Head-on escape velocities of a bed's particles from each other and from its walls, and their Bond number, by
cohesion-mapping."""

import math
from pathlib import Path

from cohesion_studies.case_entries import gravity, script_numbers
from cohesion_studies.mapping_program import MappingProgram

HERE = Path(__file__).resolve().parent

SCRIPTS = {"lammps": "bed.lmp", "liggghts": "bed.liggghts"}
PLACES = {"v_esc": "particles", "v_esc_side": "side", "v_esc_plate": "plate"}
ON, OFF = ("on", "yes", "true"), ("off", "no", "false")


def escape_velocities(build, row):
    """{"v_esc", "v_esc_side", "v_esc_plate": [m/s]} of the bed with the parameters `row` (bed_case.parameters()): below
    it two particles stick when they meet head-on, or a particle to a side wall or the plate, in the law and scheme
    that the bed is run with, in the mean where that is left to chance. Raises MappingError, or ValueError for words
    in the place of numbers."""
    return {name: escape_velocity(build, row, place) for name, place in PLACES.items()}


def escape_velocity(build, row, place):
    """That of one place of PLACES; 0 without cohesion there."""
    share, well = factor(row[f"cohesion_{place}"]), row.get("law") == "square_well"
    doubled = 2 if well and place != "particles" else 1  # as in bed.lmp
    strength = share * doubled * float(row["D" if well else "A"])
    law, scheme = "well" if well else "hamaker", row["scheme"]
    if strength == 0:
        return 0.0
    words = [f"--{law}-scheme", scheme, "--ratio", row.get("ratio", 1.01)]
    if scheme == "sampled":
        words += ["--step", row["dt"]]
    if place != "particles":
        words.append("--wall")
    return mapped(build, row, law, strength, *words)[f"{law}_mean"]


def bond_number(build, row):
    """Hamaker force of two particles that touch over the weight of one [1]; 0 without, nan of square wells, which have
    no force. Raises as escape_velocities()."""
    if row.get("law") == "square_well":
        return math.nan
    strength = factor(row["cohesion_particles"]) * float(row["A"])
    if strength == 0:
        return 0.0
    of = script_numbers(HERE / "case" / SCRIPTS[row["engine"]])
    weight = of["density"] * math.pi / 6 * of["d"]**3 * gravity(HERE / "case")
    return mapped(build, row, "hamaker", strength)["adhesion_force"] / weight


def mapped(build, row, law, strength, *words):
    """What cohesion-mapping has for one strength, A or D, of a law between the bed's particles."""
    of = script_numbers(HERE / "case" / SCRIPTS[row["engine"]])
    found, = MappingProgram(build).table(
        "to-hamaker" if law == "well" else "to-well", [strength], "--radius", of["d"] / 2, "--density", of["density"],
        "--stiffness", row["K"], "--damping", row["eta"], "--cutoff", of["H_cut"], of["H_out"], *words)
    return found


def factor(word):
    """What the engines' formulas make of a number, or of a word for on and off."""
    return 1.0 if word in ON else 0.0 if word in OFF else float(word)
