# SPDX-License-Identifier: BSD-3-Clause
"""Reads the beds that begin at minimum fluidisation (entry `begin` of constant/bed): the first cavities, the
circulation of the spheres and the number of collisions after the gas changes. Lengths in m, velocities in m/s."""

import numpy as np

import analyse
from cohesion_studies.case_entries import particle_step
from cohesion_studies.cavities import cavities, width_of
from cohesion_studies.foam_results import read_cloud, written_times
from cohesion_studies.lammps_run import tables

CENTRE, SIDE = 1 / 6, 1 / 3  # of the width, from the middle: the centre is nearer, the sides are farther
EARLY = 0.4  # s, in which the source shows its first bubble


def after(bed):
    """Times after the gas changes, from that change on, and their folders."""
    return [(time - bed.begin, folder) for time, folder in sorted(written_times(bed.case).items())
            if time > bed.begin + 1e-6]


def history(bed):
    """[(time, cavities)] after the gas changes; each cavity an array of its rows and columns."""
    return [(time, cavities(analyse.void_fraction(bed, folder) > analyse.EMPTY)) for time, folder in after(bed)]


def mirrored(members, across):
    """Share of a cavity's cells that have another of its cells at the mirror place, left for right."""
    cells = set(map(tuple, members))
    return sum((row, across - 1 - column) in cells for row, column in cells) / len(cells)


def first_cavities(found, across, cell_height):
    """Of history(): whether a bubble comes before the first slug, when that slug is first seen and how high its middle
    is above the plate, its share of mirrored cells; nan without a slug. The largest cavity, in cells."""
    slugs = [(time, members) for time, every in found for members in every
             if width_of(members, across) >= analyse.SLUG]
    when, slug = slugs[0] if slugs else (np.inf, None)
    early = [members for time, every in found if time < min(when, EARLY) for members in every if len(members) > 1]
    height = (slug[:, 0].mean() + 0.5) * cell_height if slugs else np.nan
    return {"bubble_before_slug": float(bool(early)), "slug_time": float(when) if slugs else np.nan,
            "slug_height": float(height), "slug_mirrored": mirrored(slug, across) if slugs else np.nan,
            "largest_cavity_cells": max((len(members) for _, every in found for members in every), default=0)}


def satellites(found):
    """The most cavities that are, at one time, wholly above the largest one."""
    most = 0
    for _, every in found:
        top = max(every, key=len)[:, 0].max() if every else 0
        most = max(most, sum(members[:, 0].min() > top for members in every))
    return int(most)


def circulation(bed):
    """Mean velocity upwards of the spheres in the centre and beside the walls, over the written times."""
    rows = []
    for _, folder in after(bed):
        places, velocities = read_cloud(folder)
        off = abs(places[:, 0] / bed.width - 0.5)
        rows.append([velocities[band, 1].mean() for band in (off < CENTRE, off > SIDE)])
    return dict(zip(("centre_velocity", "side_velocity"), np.mean(rows, axis=0).tolist()))


def jet_void_excess(bed):
    """Void fraction of the lowest cells above the jet, less that beside it, mean over the written times."""
    left, jet = int(bed.sideCells), int(bed.jetCells)
    rows = np.mean([analyse.void_fraction(bed, folder)[0] for _, folder in after(bed)], axis=0)
    return float(rows[left:left + jet].mean() - np.delete(rows, range(left, left + jet)).mean())


def collisions(bed):
    """Per second, between the last line of the log before the gas changes and its last: all, and those that the rule
    against inelastic collapse has not made elastic."""
    gas = tables((bed.case / "log.lammps").read_text())[1:]  # without the run that settles the bed
    time, every, elastic = (np.concatenate([table[name] for table in gas])
                            for name in ("Step", "v_collisions", "v_elastic"))
    time = time * particle_step(bed.case)
    first = np.searchsorted(time, bed.begin + 1e-9) - 1
    rate, of_rule = ((count[-1] - count[first]) / (time[-1] - time[first]) for count in (every, elastic))
    return {"collisions_per_s": float(rate), "collisions_without_rule_per_s": float(rate - of_rule)}


def figures(bed):
    """Those of one bed that are one number."""
    (across, up), found = bed.cells, history(bed)
    return {**first_cavities(found, across, bed.height / up), "satellites": satellites(found), **circulation(bed),
            "jet_void_excess": jet_void_excess(bed), **collisions(bed)}
