# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished pouring: area fraction of the bed, energy, how far it is at rest. Lengths in m, energies
in J."""

from pathlib import Path

import numpy as np

from cohesion_studies.lammps_run import tables

DIAMETER = 4e-3
GRAVITY = 9.81  # m/s2
POURED = 1e-3  # of the energy at the start: the bed is poured once no more than that is motion
MARGIN = 3.0  # diameters left out beside walls, floor and surface
COLUMNS = 12  # of the bed, each with its own highest sphere
RASTER = 50  # points per diameter


def spheres(folder):
    """x, y of all spheres at the end."""
    return np.loadtxt(Path(folder) / "spheres.txt", skiprows=9)[:, 1:3]


def surface(places, width):
    """Mean height of the tops of the highest spheres, one from each of COLUMNS columns as wide as another."""
    column = np.minimum((places[:, 0] / width * COLUMNS).astype(int), COLUMNS - 1)
    return np.mean([places[column == c, 1].max() + DIAMETER / 2 for c in range(COLUMNS)])


def window(places, width):
    """x from, x to, y from, y to: MARGIN from walls, floor and surface."""
    edge = MARGIN * DIAMETER
    return edge, width - edge, edge, surface(places, width) - edge


def area_fraction(places, box):
    """Share of the window `box` that discs cover, by a raster of points. Each disc counts with its part in it."""
    left, right, bottom, top = box
    x, y = (np.arange(low, high, DIAMETER / RASTER) + DIAMETER / RASTER / 2
            for low, high in ((left, right), (bottom, top)))
    covered = np.zeros((len(y), len(x)), bool)
    radius = DIAMETER / 2
    for px, py in places:
        i0, i1 = np.searchsorted(x, (px - radius, px + radius))
        j0, j1 = np.searchsorted(y, (py - radius, py + radius))
        near = (x[None, i0:i1] - px)**2 + (y[j0:j1, None] - py)**2 <= radius**2
        covered[j0:j1, i0:i1] |= near
    return covered.mean()


def whole_bed(places, width):
    """Area of all discs over that below the surface, walls and floor included."""
    return len(places) * np.pi / 4 * DIAMETER**2 / (width * surface(places, width))


def energy(log, dt):
    """Of the table of the log: dict of times [s] and energies, all over the energy at the start, height above the floor
    counted: motion (rotation included), height, lost; rotation alone; the error, which is the missing or excess energy,
    and its bound.

    The grid's step is exact for free flight. With a collision at the time s into a step the momentum p that a
    wall gives upwards changes the energy by g p (dt/2 - s) more than the collision takes; between spheres these
    cancel. So the error is at most g dt/2 times all that the walls have given."""
    table = tables(log)[0]
    motion = table["c_motion"] + table["c_rotation"]
    start = motion[0] + table["f_down"][0]
    parts = {name: values / start for name, values in
             (("motion", motion), ("height", table["f_down"]), ("lost", table["v_lost"]))}
    return {"time": table["Step"] * dt, **parts, "error": sum(parts.values()) - 1,
            "rotation": table["c_rotation"] / start,
            "bound": GRAVITY * dt / 2 * table["v_wall_impulse"] / start}


def figures(folder, log, width, dt):
    """Those of one run, numbers only."""
    places, found, table = spheres(folder), energy(log, dt), tables(log)[0]
    moving = np.flatnonzero(found["motion"] > POURED)
    poured = min(moving[-1] + 1, len(found["time"]) - 1)
    error, time = found["error"], found["time"]
    rest = slice(poured, None)
    return {"area_fraction": float(area_fraction(places, window(places, width))),
            "whole_bed": float(whole_bed(places, width)),
            "height_diameters": float(surface(places, width) / DIAMETER),
            "poured_s": float(time[poured]),
            "error_poured_percent": 100 * float(abs(error[:poured + 1]).max()),
            "error_end_percent": 100 * float(error[-1]),
            "error_per_s_at_rest_percent": 100 * float(np.polyfit(time[rest], error[rest], 1)[0]),
            "error_over_bound": float((abs(error[1:]) / found["bound"][1:].clip(1e-12)).max()),
            "motion_end": float(found["motion"][-1]),
            "rotation_percent": 100 * float(found["rotation"].max()),
            "overlap_diameters": float(max(0.0, 1 - closest(places) / DIAMETER)),
            "collisions": float(table["v_collisions"][-1]),
            "collisions_per_step": float(np.polyfit(table["Step"][rest], table["v_collisions"][rest], 1)[0]),
            "given_percent": 100 * float(table["v_given"][-1] / (table["c_motion"][0] + table["f_down"][0])),
            "share_at_rest": float(table["v_at_rest"][-1] / table["v_collisions"][-1])}


def closest(places):
    """Smallest distance of two centres."""
    apart = np.linalg.norm(places[:, None] - places[None], axis=2)
    np.fill_diagonal(apart, np.inf)
    return apart.min()
