# SPDX-License-Identifier: BSD-3-Clause
"""What a build folder holds, and why not what it does not."""

import re
from pathlib import Path

from cohesion_studies.package_tree import SUMMARY  # what is built, and what is left out for which reason


def missing(build, file, *parts):
    """Why the folder `build` has no `file`, which needs these `parts`, as the summary calls them; empty when it has
    it."""
    file = Path(build) / file
    if file.is_file():
        return ""
    summary = Path(build) / SUMMARY
    text = summary.read_text() if summary.is_file() else ""
    reason = re.search(rf"^ *({'|'.join(parts)}): left out, (.*)", text, re.M)
    if reason:
        return f"the {reason[1]} was left out of '{build}': {reason[2]}"
    return f"'{file}' does not exist: build the package first (scripts/setup does), or install this part of it"
