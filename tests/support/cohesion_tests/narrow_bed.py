# SPDX-License-Identifier: BSD-3-Clause
"""The case of examples/fluidised-bed in a quarter of its width, a thousand particles."""

from cohesion_studies.bed import bed_case
from cohesion_studies.bed.geometry import FILE, Geometry

SHARE = 4


def make_narrow(case):
    """Changes a copy of the case. Its cells keep their width, but for what makes their number odd, so that every second
    one of the plate blows."""
    whole = Geometry.read(case)
    narrow = Geometry(whole.width / SHARE, whole.across // SHARE // 2 * 2 + 1, whole.up)
    (case / FILE).write_text(narrow.text())
    entries = case / bed_case.COUPLING
    entries.write_text(entries.read_text().replace(f"width   {whole.width};", f"width   {narrow.width};"))
