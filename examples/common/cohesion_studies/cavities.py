# SPDX-License-Identifier: BSD-3-Clause
"""Cavities of a bed, bubbles and slugs: connected sets of cells that hold few particles."""

import numpy as np
from scipy.ndimage import label


def cavities(empty):
    """Connected sets (by faces) of cells that are `empty`, a bool (up, across); each an array of its rows and columns.
    Those that reach the highest row are none but the space above the bed."""
    labels, count = label(empty)
    found = [np.argwhere(labels == one) for one in range(1, count + 1)]
    return [members for members in found if members[:, 0].max() < empty.shape[0] - 1]


def width_of(members, across):
    """Share of the bed's width that a cavity is wide; `across`: cells of the bed."""
    return (np.ptp(members[:, 1]) + 1) / across
