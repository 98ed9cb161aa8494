# SPDX-License-Identifier: BSD-3-Clause
"""What a case of the bed says, as two fluids or as parcels of grains: expansion and pressure over time."""

import re
from pathlib import Path

import numpy as np

from cohesion_studies.case_entries import entries, gravity
from cohesion_studies.foam_results import function_table, read_cells, written_times

BED = "constant/bed"  # of a case of grains

FROM = 0.3  # share of the time that the bed has to come to its state
BLOCKS = 5  # of the rest, for the error
OUTLET = 1.01e5  # [Pa]


def of_grains(case):
    return (Path(case) / BED).exists()


def mesh(case):
    """Columns, rows, height [m] of the mesh."""
    size = entries(Path(case) / (BED if of_grains(case) else "system/blockMeshDict"))
    return int(size["columns"]), int(size["rows"]), size["height"]


def fractions(case):
    """Times [s] and solid fractions (time, row, column), of the written ones; of grains from their first step on."""
    columns, rows, _ = mesh(case)
    name = "voidFraction" if of_grains(case) else "alpha.particles"
    found = {time: folder / name for time, folder in written_times(case).items()
             if (folder / name).exists() and (time > 0 or not of_grains(case))}
    times = sorted(found)
    values = np.array([read_cells(found[t], columns * rows).reshape(rows, columns) for t in times])
    return np.array(times), 1 - values if of_grains(case) else values


def heights(case):
    """Times [s] and twice the height of the centre of mass [m]."""
    _, rows, height = mesh(case)
    times, solid = fractions(case)
    y = (np.arange(rows) + 0.5) * height / rows
    layers = solid.mean(axis=2)
    return times, 2 * (layers * y).sum(axis=1) / layers.sum(axis=1)


def expansion(case):
    """Times [s] and expansions [1]: heights() over the height at the start, of grains over that which they have at the
    solid fraction from which the two fluids start, less 1."""
    times, found = heights(case)
    return times, found / (entries(Path(case) / BED)["rest"] if of_grains(case) else found[0]) - 1


def weight(case):
    """Of the grains over the area [Pa]."""
    if of_grains(case):
        bed = entries(Path(case) / BED)
        return bed["solid"] * bed["rest"] * bed["density"] * gravity(case)
    _, rows, height = mesh(case)
    layers = fractions(case)[1][0].mean(axis=1)
    density = entries(Path(case) / "constant/thermophysicalProperties.particles")["rho"]
    return layers.sum() * height / rows * density * gravity(case)


def pressure(case):
    """Times [s] and the drop of pressure over the bed, over its weight [1]."""
    table = np.loadtxt(function_table(case, "pressureDrop", "surfaceFieldValue.dat"))
    if of_grains(case):  # per density of the gas, and 0 at the outlet
        drop = table[:, 1] * entries(Path(case) / "constant/transportProperties")["rho"]
    else:
        drop = table[:, 1] - OUTLET
    return table[:, 0], drop / weight(case)


def mean_and_error(times, values, end):
    """Mean of the values from FROM of the time on, and its standard error by the means of BLOCKS equal times."""
    edges = np.linspace(FROM * end, end, BLOCKS + 1)
    blocks = [values[(times > low) & (times <= high)] for low, high in zip(edges, edges[1:])]
    means = np.array([block.mean() for block in blocks])
    return means.mean(), means.std(ddof=1) / np.sqrt(BLOCKS)


def figures(case, end=None):
    """Of a finished case, or of its first `end` seconds."""
    times, expanded = expansion(case)
    end = end or times[-1]
    mean, error = mean_and_error(times, expanded, end)
    pressure_times, drop = pressure(case)
    late = (pressure_times > FROM * end) & (pressure_times <= end)
    # Up to where layers hold, in the mean, half of what they held at the start
    layers = fractions(case)[1][(times > FROM * end) & (times <= end)].mean(axis=(0, 2))
    full = np.nonzero(layers > 0.3)[0]
    log = Path(case) / ("log.cohesiveBedFoam" if of_grains(case) else "log.twoPhaseEulerFoam")
    return {"expansion": float(mean), "expansion_error": float(error),
            "pressure_mean": float(drop[late].mean()), "pressure_deviation": float(drop[late].std()),
            "dense_height": float((full[-1] + 1) / len(layers) * mesh(case)[2]) if len(full) else 0.0,
            "steps": len(re.findall(r"^Time = ", log.read_text(), re.M)) * end / times[-1]}
