# SPDX-License-Identifier: BSD-3-Clause
"""What coarse graining changes of the figures of a bed."""

import math
import statistics

from cohesion_studies.study_table import aligned, over_seeds

FIGURES = ("U_mf", "overshoot", "opens_at", "pressure", "pressure_deviation", "expansion")


def changes(kinds):
    """Text: by how much each figure of parcels differs from that of the first kind, with the standard error of that, and
    the time saved."""
    found = {kind: over_seeds(results) for kind, results in kinds.items()}
    (first, of_grains), *others = found.items()
    lines = [("changed against " + first, *(kind for kind, _ in others))]
    for name in FIGURES:
        lines.append((name, *(change(name, kinds[first], kinds[kind]) for kind, _ in others)))
    seconds = of_grains["processor_seconds"][0]
    lines.append(("times as fast", *(f"{seconds / figures['processor_seconds'][0]:.3g}" for _, figures in others)))
    return aligned(lines)


def change(name, before, after):
    """Of the mean, with its standard error where there are seeds."""
    means = [statistics.fmean(result[name] for result in results) for results in (before, after)]
    errors = [statistics.stdev(result[name] for result in results) / math.sqrt(len(results))
              for results in (before, after) if len(results) > 1]
    text = f"{means[1] - means[0]:+.2g}"
    return f"{text} +- {math.hypot(*errors):.1g}" if len(errors) == 2 else text
