# SPDX-License-Identifier: BSD-3-Clause
"""How ratios of runs in turns are shown."""
import statistics


def spread(ratios):
    """Median, and the quarter and three quarter points."""
    ratios = sorted(ratios)
    low, middle, high = statistics.quantiles(ratios, n=4) if len(ratios) > 1 else 3 * ratios
    return f"{middle:.3f} ({low:.3f} to {high:.3f})"
