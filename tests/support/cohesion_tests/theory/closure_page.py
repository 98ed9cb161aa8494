# SPDX-License-Identifier: BSD-3-Clause
"""What docs/openfoam-coupling/drag_closures.md states of the closures: the rows of its tables."""
import re

from cohesion_tests import SOURCE
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

PAGE = SOURCE / "docs/openfoam-coupling/drag_closures.md"
#: Void fraction and Reynolds number of the last column of the table of closures.
PACKED = (0.4, 100)


def rows(heading):
    """The rows under a heading that begin with the name of a closure: name -> further cells."""
    text = re.search(rf"^## {heading}\n(.*?)(?=^## |\Z)", PAGE.read_text(), re.M | re.S)[1]
    found = {}
    for line in re.findall(r"^\| `.*\|$", text, re.M):
        name, *cells = (cell.strip() for cell in line.strip("|").split("|"))
        if name.strip("`") in CLOSURES:
            found[name.strip("`")] = cells
    return found


class Range:
    """Where a closure was fitted, of its row."""

    def __init__(self, name):
        cells = rows("Closures")[name]
        self.lowest, self.highest = map(float, cells[3].split("-"))
        self.reynolds = float(cells[4].replace(",", ""))

    def __contains__(self, point):
        eps, reynolds = point
        return self.lowest <= eps <= self.highest and reynolds <= self.reynolds


def packed(name):
    """F_total over Stokes' drag at PACKED, in brackets outside the range, as the page prints it."""
    eps, reynolds = PACKED
    total = CLOSURES[name](DOUBLE, eps, reynolds / eps, 1, 1, 1) / 18 / eps**2
    value = f"{float(f'{total:.3g}'):g}"
    return value if PACKED in Range(name) else f"({value})"


if __name__ == "__main__":
    for closure in CLOSURES:
        print(f"{closure} {packed(closure)}")
