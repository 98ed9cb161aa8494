# SPDX-License-Identifier: BSD-3-Clause
"""Pictures without a screen. Import it before matplotlib.pyplot, or take `pyplot` from here."""

from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402
from matplotlib.ticker import LogFormatterSciNotation  # noqa: E402

MARKERS = "os^vDPX*"  # so that lines differ without their colours


def save(figure, file, dpi=100):
    """Writes and closes the figure, in a folder that is made where there is none, and says where it is."""
    file = Path(file)
    file.parent.mkdir(parents=True, exist_ok=True)
    # Without the library's version: the same figures give the same file.
    figure.savefig(file, dpi=dpi, metadata={"Software": None} if file.suffix == ".png" else None)
    pyplot.close(figure)
    print(f"picture: {file}")


def label_between_decades(axis):
    """Numbers between the powers of ten as well, on an x or y axis of logarithms that spans one or two."""
    axis.set_minor_formatter(LogFormatterSciNotation(labelOnlyBase=False, minor_thresholds=(2.5, 0.8)))
    axis.set_tick_params(which="minor", labelsize=7)


def circles(axes, places, diameter, **look):
    """Of a diameter in units of the axes, which become equal; `look`: colours and the like. Gives them."""
    size = np.full(len(places), diameter)
    found = EllipseCollection(size, size, np.zeros_like(size), units="xy", offsets=places,
                              offset_transform=axes.transData, **look)
    axes.add_collection(found)
    axes.set_aspect("equal")
    return found
