# SPDX-License-Identifier: BSD-3-Clause
"""What is read of one finished case of the fluidised bed: all of it, and what of it is one number."""

from pathlib import Path

from cohesion_studies import case_entries, cavities, ergun, foam_results
from cohesion_studies.bed import analyse, particles
from cohesion_studies.job_pool import digest_of


def programs():
    """Mark of the programs that these figures are read by: with others they are read again."""
    readers = (analyse, case_entries, cavities, ergun, foam_results, particles)
    return digest_of([Path(__file__), *(Path(module.__file__) for module in readers)])


def evaluate(case):
    """Raises EntryError for a case that has not run to its end, once, or lacks what is read."""
    seconds = analyse.solver_seconds(case)  # first: tells a case that was killed
    steps = analyse.curve(case)
    velocities = analyse.velocities(steps)
    plateau, balance = analyse.plateau(case, velocities)
    mean, deviation, error = analyse.packed_void_fraction(case)
    bed = analyse.Bed.read(case)
    return {
        "steps": steps,
        "velocities": velocities,
        "plateau": plateau,
        "balance": balance,
        "void_fraction": (mean, deviation, error),
        "ergun": [bed.minimum_fluidisation(mean + s * deviation) for s in (-1, 1)],
        "mixing": particles.mixing(case),
        "movement": particles.movement(case),
        "plugging": particles.plugging(case),
        "widest_cavity": particles.widest_cavity(case),
        "forces": particles.forces(case, velocities.opens),
        "noise": analyse.pressure_noise(case),
        "exchange_ms": analyse.exchange_milliseconds(case),
        "seconds": seconds,
    }


def single(found):
    """Those of evaluate() that are one number, each under one name."""
    velocities = found["velocities"]
    return {"U_mf_df": velocities.falling[0], "U_mf_th": velocities.rising[0],
            "U_mf_in": velocities.opening[0], "overshoot": velocities.overshoot[0],
            "overshoot_over_plateau": velocities.overshoot[0] + 1 - found["plateau"][0],
            "pressure_over_weight": found["plateau"][0], "balance": found["balance"][0],
            "void_fraction": found["void_fraction"][0], "mixing": found["mixing"][0],
            "mixed": found["mixing"][1], "movement": found["movement"][0], "movement_at": found["movement"][1],
            "plugging": found["plugging"], "widest_cavity": found["widest_cavity"], "pressure_noise": found["noise"],
            **{f"{name}_at_maximum": share for name, share in found["forces"].items()},
            "exchange_ms_per_step": found["exchange_ms"]}
