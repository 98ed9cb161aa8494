# SPDX-License-Identifier: BSD-3-Clause
"""analyse.py CASE [FROM]: the drag of squares of cells over that of the law at their mean values, in a periodic box, by
the size of the squares and their solid fraction; written times from FROM [s] on (0.5)."""

import re
import sys
from pathlib import Path

import numpy as np

from cohesion_studies.case_entries import entries
from cohesion_studies.foam_results import read_cells, written_times

D, MU, RHO = 75e-6, 1.8e-5, 1.2
TINY = np.finfo(float).tiny
EDGES = np.array([0, 0.01, 0.03, 0.06, 0.1, 0.2, 0.4])  # of bins of the solid fraction


def wen_yu(solid, slip):
    """beta (kg/m3/s) of Wen and Yu with n = 4.65 (src/drag/wen_yu.h), as the solver takes it."""
    eps = 1 - solid
    reynolds = np.maximum(eps * RHO * slip * D / MU, 1e-12)
    drag = np.where(reynolds < 1000, 24 / reynolds * (1 + 0.15 * reynolds**0.687), 0.44)
    return 0.75 * drag * solid * eps * RHO * slip / D * eps**-2.65


def vectors(file, count):
    text = Path(file).read_text()
    rows = re.search(r"^internalField[^(]*\n\(\n(.*?)\n\)", text, re.M | re.S)
    if rows is None:
        words = re.search(r"^internalField\s+uniform \(([^)]*)\)", text, re.M)[1]
        return np.tile(np.array(words.split(), float), (count, 1))
    return np.array(re.sub("[()]", " ", rows[1]).split(), float).reshape(count, 3)


def snapshots(case, start):
    """Of each written time from `start` on: solid fraction (n, n) and both velocities (n, n, 3) [m/s]."""
    n = int(entries(Path(case) / "system/blockMeshDict")["rows"])
    for time, folder in sorted(written_times(case).items()):
        if time >= start and (folder / "alpha.particles").exists():
            yield (read_cells(folder / "alpha.particles", n * n).reshape(n, n),
                   *(vectors(folder / f"U.{phase}", n * n).reshape(n, n, 3) for phase in ("particles", "air")))


def means(values, cells):
    """Of all squares of so many cells, side by side: (squares, ...)."""
    n = len(values) // cells
    blocks = values[:n * cells, :n * cells].reshape(n, cells, n, cells, *values.shape[2:])
    return blocks.mean(axis=(1, 3)).reshape(n * n, *values.shape[2:])


def squares(solid, particles, gas, cells):
    """Of all squares: fraction, drag along gravity [N/m3], vertical slip [m/s], and the law's drag at the mean fraction
    and slip [N/m3]. Means of velocities are those of the phases' momentum, 0 of particles where there are none."""
    slip = gas - particles
    drag = wen_yu(solid, np.linalg.norm(slip, axis=2)) * slip[..., 1]
    phi = means(solid, cells)
    mean_slip = (means(gas * (1 - solid)[..., None], cells) / (1 - phi)[:, None]
                 - means(particles * solid[..., None], cells) / np.maximum(phi, TINY)[:, None])
    law = wen_yu(phi, np.linalg.norm(mean_slip, axis=1)) * mean_slip[:, 1]
    return phi, means(drag, cells), mean_slip[:, 1], law


def filtered(case, cells, start):
    """Of all squares together, then of each bin of EDGES: drag over the law's at the mean values, standard error of the
    times taken as independent, number of squares; NaN where a bin has none."""
    taken = [squares(*fields, cells) for fields in snapshots(case, start)]
    rows = []
    for low, high in [(0, 1), *zip(EDGES, EDGES[1:])]:
        inside = [(phi >= low) & (phi < high) for phi, *_ in taken]
        sums = np.array([[drag[i].sum(), law[i].sum()] for i, (_, drag, _, law) in zip(inside, taken)])
        total = sums.sum(axis=0)
        count = sum(int(i.sum()) for i in inside)
        ratio = total[0] / total[1] if count else np.nan
        residual = sums[:, 0] - ratio * sums[:, 1]
        times = len(sums)
        error = np.sqrt(times / (times - 1) * (residual**2).sum()) / abs(total[1]) if count and times > 1 else np.nan
        rows.append((low, high, ratio, error, count))
    return rows


def sizes(case):
    """Cells along squares, and their edges [m]: 1, 2, 4 ... to half of the box."""
    size = entries(Path(case) / "system/blockMeshDict")
    n = int(size["rows"])
    return [(2**k, 2**k * size["height"] / n) for k in range(n.bit_length() - 1)]


def by_size(case, start):
    """Edge of squares [m], filtered() of all of them together: drag over the law's, error."""
    return [(edge, *filtered(case, cells, start)[0][2:4]) for cells, edge in sizes(case)]


def main():
    case, start = Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 0.5
    for cells, edge in sizes(case):
        print(f"filter {edge:.4g} m")
        for low, high, ratio, error, count in filtered(case, cells, start):
            if count:
                print(f"  phi {low:.2f} to {high:.2f}: {ratio:.3f} +- {error:.3f} ({count} squares)")


if __name__ == "__main__":
    main()
