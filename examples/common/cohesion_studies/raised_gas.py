# SPDX-License-Identifier: BSD-3-Clause
"""Reads a finished bed through which the gas was raised evenly: minimum fluidisation, overshoot, pressure drop and
height."""

import math

import numpy as np

from cohesion_studies.case_entries import entries
from cohesion_studies.foam_results import function_table

FIT = 0.2, 0.85  # of the bed's weight: pressure drops between which the resting bed's line is fitted
WINDOW = 0.01    # s over which the pressure drop is averaged: a hundredth of the ramp, some contacts of bed and plate


def course(case):
    """Time [s], superficial velocity [m/s] and pressure drop over weight, at the gas steps."""
    table = np.loadtxt(function_table(case, "drop", "bedPressureDrop.dat"))
    return table[:, 0], table[:, 2], table[:, 5]


def smoothed(time, values):
    """Mean over WINDOW."""
    width = max(1, round(WINDOW / (time[-1] - time[0]) * (len(time) - 1)))
    return np.convolve(values, np.ones(width) / width, mode="same")


def resting_line(velocity, drop):
    """a, b of a U + b U^2, of the resting bed's pressure drop over its weight up to the first that is above FIT."""
    if drop.max() < FIT[1]:
        raise ValueError(f"the gas has not opened the bed: its pressure drop is at most {drop.max():.3g} of the weight")
    use = np.arange(len(drop)) < np.argmax(drop > FIT[1])
    use &= drop > FIT[0]
    (a, b), *_ = np.linalg.lstsq(np.column_stack([velocity[use], velocity[use]**2]), drop[use], rcond=None)
    return a, b


def section(case):
    """Cross-section of a case of cohesion-powder [m2]."""
    size = entries(case / "constant/grains")
    return math.pi * size["radius"]**2 if size["round"] else size["width"] * size["depth"]


def figures(case, options, ramp):
    """`options`: of cohesion-powder; ramp: how long the gas rises [s]."""
    time, velocity, drop = course(case)
    a, b = resting_line(velocity, drop)
    heights = np.loadtxt(function_table(case, "height", "bedHeight.dat"))
    smooth = smoothed(time, drop)
    rising, held = time < ramp, time > ramp
    number = float((case / "grains.data").read_text().split(" atoms")[0].split()[-1])
    parcel = options.get("--coarse-graining", 1) * options["--diameter"]
    return {
        "U_mf": 2 / (a + math.sqrt(a**2 + 4 * b)),
        "void_fraction": 1 - number * math.pi / 6 * parcel**3 / section(case) / heights[0, 1],
        "overshoot": float(smooth[rising].max() - 1),
        "opens_at": float(velocity[rising][smooth[rising].argmax()]),
        "pressure": float(drop[held].mean()),
        "pressure_deviation": float(drop[held].std()),
        "expansion": float(heights[heights[:, 0] > ramp, 1].mean() / heights[0, 1]),
        "spheres": number,
    }
