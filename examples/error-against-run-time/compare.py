# SPDX-License-Identifier: BSD-3-Clause
"""Errors of the runs of a scene, apart from what is left to chance; which settings are worth their time."""

import csv
import io
import math
from collections import namedtuple

import numpy as np
from scipy.special import stdtrit

from job import BLOCKS
from scene import Setting

CONFIDENCE = 0.95

# error: of the setting, over the quantity's scale; margin: of it at 95 %, from seeds or blocks, and what the
# quantity does not resolve, NaN where it is not known; seconds: (least, median, most) of its runs; failure:
# why there is no error.
Row = namedtuple("Row", "setting error margin seconds failure")


def upper(row):
    """What the error is below, at 95 %; inf when not known."""
    value = row.error + row.margin
    return value if math.isfinite(value) else math.inf


def resolved(row):
    """Whether the error is more than chance and the resolution of the quantity."""
    return row.error > row.margin


def times(outcomes):
    seconds = [outcome.seconds for outcome in outcomes]
    return min(seconds), float(np.median(seconds)), max(seconds)


def deviation(quantity, outcomes, references):
    """Error and margin. With a run as reference each seed is compared with the same seed: what both have in
    common is no chance."""
    values = np.array([outcome.values[quantity.name][0] for outcome in outcomes])
    blocks = [outcome.values[quantity.name][1] for outcome in outcomes]
    if references is None:
        known = np.full(len(values), quantity.reference)
    else:
        known = np.array([outcome.values[quantity.name][0] for outcome in references])
        blocks += [outcome.values[quantity.name][1] for outcome in references]
    scale = quantity.scale or abs(known.mean())
    away = (values - known) / scale
    if quantity.over_seeds == "largest":
        error = float(np.abs(away).max())
        return error, quantity.resolution + quantity.grade * error
    error = float(abs(away.mean()))
    return error, chance(quantity, away, blocks, scale) + quantity.resolution + quantity.grade * error


def chance(quantity, away, blocks, scale):
    """Of a mean over seeds; of one seed's mean over time from its blocks."""
    n = len(away)
    if n > 1:
        return float(quantile(n - 1) * away.std(ddof=1) / n**0.5)
    if quantity.take != "mean":
        return 0.0
    if any(block is None for block in blocks):
        return math.nan
    return float(quantile(BLOCKS - 1) * np.hypot.reduce(blocks) / scale)


def quantile(freedom):
    return stdtrit(freedom, 0.5 + CONFIDENCE / 2)


def rows(quantity, results, seeds):
    """A Row for each setting; `results`: Setting -> [Outcome of each run], the first `seeds` of them with other
    seeds, the rest repeated for their time."""
    of_run = isinstance(quantity.reference, Setting)
    references = results[quantity.reference][:seeds] if of_run else None
    found = []
    for setting, outcomes in results.items():
        if of_run and setting == quantity.reference:
            continue
        bad = [o.failures[quantity.name] for o in outcomes if quantity.name in o.failures]
        bad += ["reference: " + o.failures[quantity.name] for o in references or ()
                if quantity.name in o.failures]
        error, margin = (math.nan, math.nan) if bad else deviation(quantity, outcomes[:seeds], references)
        found.append(Row(setting, error, margin, times(outcomes), bad[0] if bad else ""))
    return found


def front(rows):
    """The rows for which nothing is as fast and surely as good (Pareto), by time."""
    best, kept = math.inf, []
    for row in sorted((row for row in rows if not row.failure), key=lambda row: (row.seconds[1], upper(row))):
        if upper(row) < best:
            best = upper(row)
            kept.append(row)
    return kept


def recommended(rows, wish):
    """The fastest setting whose error is surely not above `wish`, or None."""
    good = [row for row in front(rows) if upper(row) <= wish]
    return good[0] if good else None


def at_error(rows, wish):
    """Step and seconds at which a scheme's error is `wish`: between the largest good step and the next one;
    those of the largest step where it is good enough; None where no step is."""
    rows = sorted((row for row in rows if not row.failure), key=lambda row: row.setting.step)
    good = [row for row in rows if upper(row) <= wish]
    if not good:
        return None
    last = good[-1]
    worse = [row for row in rows if row.setting.step > last.setting.step and row.error > wish]
    if not worse or last.error <= 0:
        return last.setting.step, last.seconds[1]
    ends = [np.log([row.setting.step, row.seconds[1], row.error]) for row in (last, worse[0])]
    part = (math.log(wish) - ends[0][2]) / (ends[1][2] - ends[0][2])
    return tuple(np.exp(ends[0][:2] + part * (ends[1][:2] - ends[0][:2])))


def order(rows):
    """Slope of the error against the step, of the rows that are resolved; None below three."""
    good = [row for row in rows if not row.failure and resolved(row)]
    if len(good) < 3:
        return None
    return float(np.polyfit(np.log([r.setting.step for r in good]), np.log([r.error for r in good]), 1)[0])


def by_scheme(rows):
    schemes = {}
    for row in rows:
        schemes.setdefault(row.setting.scheme, []).append(row)
    return schemes


def margin_text(row):
    return "not known" if math.isnan(row.margin) else f"{row.margin:.1e}" if row.margin else ""


def report(scene, quantity, rows, wish):
    """Table and advice, as text."""
    reference = quantity.reference
    known = (f"{reference.scheme} at {scene.step} {reference.step:g}, each seed with its own"
             if isinstance(reference, Setting) else f"{reference:g} {quantity.unit}".strip())
    lines = [f"{quantity.name}: {quantity.over_seeds} of {len(scene.seeds)} seed(s); reference: {known}",
             f"  {'scheme':12s}{scene.step + ' [' + scene.step_unit + ']':>12s}{'seconds':>10s}  "
             f"{'least to most':18s}{'error':>9s}  {'+- (95 %)':10s}"]
    best = front(rows)
    for row in rows:
        low, middle, high = row.seconds
        start = f"  {row.setting.scheme:12s}{row.setting.step:12.4g}{middle:10.3g}  {f'{low:.3g} to {high:.3g}':18s}"
        if row.failure:
            lines.append(start + "  " + row.failure)
            continue
        notes = [*(["front"] if row in best else []), *(["not resolved"] if not resolved(row) else [])]
        lines.append(start + f"{row.error:9.2e}  {margin_text(row):10s}  " + ", ".join(notes))
    return "\n".join(lines + advice(scene, rows, wish)) + "\n"


def advice(scene, rows, wish):
    lines, at = [], {}
    for name, own in by_scheme(rows).items():
        at[name], slope = at_error(own, wish), order(own)
        if slope is not None:
            lines.append(f"  {name}: error goes as {scene.step}^{slope:.2f}")
    best = recommended(rows, wish)
    if best is None:
        lines.append(f"  error {wish:g}: no setting here is surely that good; take finer steps, or more seeds "
                     "where the error is not resolved")
        return lines
    lines.append(f"  error {wish:g}: recommended {best.setting.scheme}, {scene.step} {best.setting.step:g} "
                 f"{scene.step_unit}: {best.seconds[1]:.3g} s, error {best.error:.1e}")
    lines += [f"    {name}: " + ("not surely with these steps and seeds" if found is None else
                                 f"{scene.step} {found[0]:.3g}, {found[1]:.3g} s") for name, found in at.items()]
    reached = {name: found for name, found in at.items() if found}
    fast = best.setting.scheme
    for name, found in reached.items():
        if name != fast:
            lines.append(f"    {name} takes {found[1] / reached[fast][1]:.3g} times as long as {fast}")
    return lines


def table(scene, all_rows):
    """The same as CSV; `all_rows`: [(Quantity, rows)]."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["quantity", "scheme", scene.step, "seconds", "seconds_least", "seconds_most", "error", "margin",
                     "front", "failure"])
    for quantity, rows in all_rows:
        best = front(rows)
        for row in rows:
            low, middle, high = row.seconds
            writer.writerow([quantity.name, row.setting.scheme, f"{row.setting.step:.6g}", f"{middle:.6g}",
                             f"{low:.6g}", f"{high:.6g}", f"{row.error:.6g}", f"{row.margin:.6g}",
                             "yes" if row in best else "no", row.failure])
    return out.getvalue()
