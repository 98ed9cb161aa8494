# SPDX-License-Identifier: BSD-3-Clause
"""Agglomerates of spheres of diameter 1 as rows of centres: from a dump, made, and among others like them; what their
form says of them."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import breadth_first_order
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

BOUND = 1.12  # distance of centres [diameters] within which spheres of one agglomerate may be bound: the range of the
#               attraction, and what the deepest overlap of a start moves


def last_frame(file):
    """Edges of the box, tilt xy, and rows of a dump of LAMMPS: id x y z radius agglomerate size."""
    lines = file.read_text().splitlines()
    start = max(k for k, line in enumerate(lines) if line.startswith("ITEM: TIMESTEP"))
    count = int(lines[start + 3])
    bounds = np.array([[float(word) for word in (line.split() + ["0"])[:3]] for line in lines[start + 5:start + 8]])
    tilt = bounds[0, 2]
    edges = bounds[:, 1] - bounds[:, 0]
    edges[0] -= abs(tilt)
    return edges, tilt, np.array([line.split() for line in lines[start + 9:start + 9 + count]], float)


def nearest_image(step, edges, tilt):
    """Of rows of differences in a box that is tilted along x with y."""
    step = step.copy()
    for axis in (2, 1, 0):
        images = np.round(step[:, axis] / edges[axis])
        step[:, axis] -= images * edges[axis]
        if axis == 1:
            step[:, 0] -= images * tilt
    return step


def unfolded(places, edges, tilt):
    """Centres of one agglomerate in one piece, sphere to sphere; None when it is bound to its own image, or by spheres
    further apart than BOUND."""
    n = len(places)
    i, j = np.triu_indices(n, 1)
    steps = nearest_image(places[j] - places[i], edges, tilt)
    near = np.linalg.norm(steps, axis=1) < BOUND
    i, j, steps = i[near], j[near], steps[near]
    graph = coo_matrix((np.ones(2 * len(i)), (np.r_[i, j], np.r_[j, i])), shape=(n, n)).tocsr()
    order, before = breadth_first_order(graph, 0)
    if len(order) < n:
        return None
    step_of = {(a, b): s for a, b, s in zip(i, j, steps)} | {(b, a): -s for a, b, s in zip(i, j, steps)}
    whole = np.zeros((n, 3))
    for k in order[1:]:
        whole[k] = whole[before[k]] + step_of[before[k], k]
    return whole if np.allclose(whole[j] - whole[i], steps, atol=1e-6) else None


def found_in(file, wanted, apart=0.2):
    """Agglomerates of a dump whose numbers of spheres are nearest to those wanted: at most one for each, and none that
    differs by more than the fraction `apart`."""
    edges, tilt, rows = last_frame(file)
    sizes = {int(label): int(size) for label, size in rows[:, 5:7] if label > 0}
    chosen = {}
    for n in wanted:
        for label in sorted((label for label in sizes if label not in chosen), key=lambda k: (abs(sizes[k] - n), k)):
            if abs(sizes[label] - n) > apart * n:
                break
            whole = unfolded(rows[rows[:, 5] == label][:, 1:4], edges, tilt)
            if whole is not None:
                chosen[label] = whole
                break
    return list(chosen.values())


def chain(n):
    """So many spheres in a row along x."""
    return np.arange(n)[:, None] * np.array([1.0, 0.0, 0.0])


def ball(n):
    """The n spheres of a face-centred lattice that are nearest to one of them; whole shells for 13, 19, 43, 55, ..."""
    reach = np.arange(-8, 9)
    lattice = np.array(np.meshgrid(reach, reach, reach)).reshape(3, -1).T
    lattice = lattice[lattice.sum(axis=1) % 2 == 0] / np.sqrt(2)
    return lattice[np.argsort(np.linalg.norm(lattice, axis=1).round(9), kind="stable")[:n]]


def radius_of_gyration(places):
    """Of centres, [diameters]."""
    return float(np.sqrt(np.mean(np.sum((places - places.mean(axis=0))**2, axis=1))))


def projected_radii(places, pixels=40):
    """Radius of the disc with the area of what is seen along x, y and z, `pixels` to a diameter. [diameters]"""
    radii = []
    for axis in range(3):
        flat = np.delete(places, axis, axis=1)
        low = flat.min(axis=0) - 0.5
        grid = [np.arange(low[k], flat[:, k].max() + 0.5, 1 / pixels) + 0.5 / pixels for k in range(2)]
        points = np.stack(np.meshgrid(*grid), axis=-1).reshape(-1, 2)
        seen = cKDTree(flat).query(points, distance_upper_bound=0.5)[0] < 0.5
        radii.append(float(np.sqrt(seen.sum() / np.pi)) / pixels)
    return radii


def suspension(places, number, phi, seed, tries=200000):
    """Centres and edge of a periodic cube with so many of one agglomerate, turned and put at random without overlap,
    at a fraction of solid. Raises ValueError when there is no room."""
    random = np.random.default_rng(seed)
    places = places - places.mean(axis=0)
    edge = (number * len(places) * np.pi / 6 / phi)**(1 / 3)
    put = np.empty((0, 3))
    for _ in range(tries):
        new = (places @ Rotation.random(random_state=random.integers(1 << 31)).as_matrix().T
               + random.random(3) * edge) % edge
        if len(put) == 0 or cKDTree(put, boxsize=edge).query(new)[0].min() >= 1.0:
            put = np.vstack([put, new])
            if len(put) == number * len(places):
                return put, edge
    raise ValueError(f"no room for {number} agglomerates of {len(places)} spheres at a fraction of {phi}")
