# SPDX-License-Identifier: BSD-3-Clause
"""Width, cells and jets of a bed's case: its constant/bed. Lengths in m."""

import re
from dataclasses import dataclass
from pathlib import Path

HEIGHT, DEPTH = 0.2, 1e-3
GRID = 5e-3  # edge of the cells that the mixing index counts in
FILE = "constant/bed"


class GeometryError(ValueError):
    """A bed cannot have these numbers."""


@dataclass(frozen=True)
class Geometry:
    """Every second cell of the plate blows, the first and the last do not."""

    width: float = 0.08
    across: int = 27  # cells
    up: int = 30

    def __post_init__(self):
        if self.across < 3 or self.across % 2 == 0:
            raise GeometryError(f"across is {self.across}: it must be odd, 3 or more, for jets in every second cell")
        if self.up < 3:
            raise GeometryError(f"up is {self.up}: it must be 3 or more")
        if not self.width > 0 or abs(self.width / GRID - round(self.width / GRID)) > 1e-6:
            raise GeometryError(f"width is {self.width} m: it must be a multiple of {GRID} m, the cells that the "
                                "mixing index counts in")

    @property
    def jets(self):
        return self.across // 2

    @property
    def share(self):
        """Of the plate that blows."""
        return self.jets / self.across

    @property
    def node(self):
        """Height of the lowest pressure node, the centres of the lowest cells."""
        return HEIGHT / self.up / 2

    def text(self):
        """constant/bed of this bed."""
        cell = self.width / self.across
        boxes = "\n".join(f"    ({(k - 0.067) * cell:.6f} -1e-4 -1) ({(k + 1.067) * cell:.6f} 1e-4 1)"
                          for k in range(1, self.across, 2))
        return f"""// Width, cells and jets of the bed: geometry.py writes this file for others.
width       {1e3 * self.width:g};     // [mm]
across      {self.across};     // cells
up          {self.up};
jetShare    {self.share:.11f};  // {self.jets} of {self.across} cells of the plate blow
lowest      {1.98 * self.node:.4g}; // below it are the centres of the lowest row of cells alone [m]
mixingCells ({round(self.width / GRID)} {round(HEIGHT / GRID)} 1);  // of {1e3 * GRID:g} mm: small beside the layers
// The second, fourth, ... cell of the plate [m].
jetBoxes
(
{boxes}
);
"""

    @staticmethod
    def read(case):
        """Of a case folder."""
        text = (Path(case) / FILE).read_text()

        def entry(name):
            return re.search(rf"^{name}\s+([^;\s]+);", text, re.M)[1]

        return Geometry(round(float(entry("width")) * 1e-3, 9), int(entry("across")), int(entry("up")))
