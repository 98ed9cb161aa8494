# SPDX-License-Identifier: BSD-3-Clause
"""The case `case` with the particle engine that is named, by the installed package; prints the solver's log."""

import sys
from pathlib import Path

from cohesion_studies.bed import bed_case
from cohesion_studies.foam_case import environment
from cohesion_studies.package_tree import own_tree

engine = sys.argv[1]
bed_case.use(Path("case"))
# What runs is asked for, and not that the particles have come to rest.
case = bed_case.make_case("bed", {"engine": engine, "settle": 0.01}, environment(own_tree(), [engine]))
print(case.solve())
