# SPDX-License-Identifier: BSD-3-Clause
"""Draws the charts of pages from the CSV files of docs/verification.

A page has a comment where the chart belongs, with its caption and a query of scripts/page-tables:

    <!-- chart Error of the velocities against the step
    select replace(step, 't_c/', '') as "steps per contact time", scheme, value as error from contact_motion
    -->

The columns are x, the name of the series (which can be left out) and y; the first and the last name label the axes.
Numbers as x give lines, words bars. "1.2 +- 0.1" and "1.2 (1.1 to 1.4)" have an error bar, and points in the place of bars.
Rows without y and those with one of OUTCOMES are left out; any other text as y is an error. Axes that span more than a
factor of SPAN are logarithmic, on which a zero is an error; where y is, x is from a factor of 4 on."""
import re
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

CHART = re.compile(r"^<!-- chart (?P<caption>[^\n]+)\n(?P<query>.*?)^-->\n", re.M | re.S)
NUMBER = r"[-+]?(?:\d{1,3}(?:,\d{3})+|\d+)(?:\.\d*)?(?:[eE][-+]?\d+)?"
OUTCOMES = {"stops", "unstable"}
SPAN = 30
MARKERS = "os^vDPX*"


def database(source):
    """Of scripts/page-tables, which has no ending."""
    loader = SourceFileLoader("page_tables", str(source / "scripts/page-tables"))
    module = module_from_spec(spec_from_loader("page_tables", loader))
    loader.exec_module(module)
    return module.database(sorted(source.glob("docs/verification/*.csv")))


def real(text):
    """With commas between thousands."""
    return float(text.replace(",", ""))


def number(text):
    """(least, value, largest) of a cell, or None."""
    text = str(text)
    if found := re.match(rf"({NUMBER}) \+- ({NUMBER})$", text):
        value, error = map(real, found.groups())
        return value - error, value, value + error
    if found := re.match(rf"({NUMBER}) \(({NUMBER}) to ({NUMBER})\)$", text):
        value, least, largest = map(real, found.groups())
        return least, value, largest
    return (real(text),) * 3 if re.fullmatch(NUMBER, text) else None


def points(base, query):
    """Names of the columns, and {series: [(x, (least, y, largest))]}."""
    found = base.execute(query)
    names, series = [name for name, *_ in found.description], {}
    for x, *name, y in found:
        if (value := number(y)) is not None:
            series.setdefault(name[0] if name else "", []).append((x, value))
        elif y is not None and y not in OUTCOMES:
            raise ValueError(f"'{y}' is no number: {query}")
    return names, series


def logarithmic(values, span=SPAN):
    positive = [value for value in values if value > 0]
    if min(values) < 0 or not positive or max(positive) <= span * min(positive):
        return False
    if min(values) == 0:
        raise ValueError(f"a zero on a logarithmic axis: {sorted(values)}")
    return True


def heights(series):
    return [y for rows in series.values() for _, (_, y, _) in rows]


def errors(values):
    """Lengths of error bars, or None where there are none."""
    found = [[value - least for least, value, _ in values], [largest - value for _, value, largest in values]]
    return found if any(map(any, found)) else None


def draw_lines(axes, series):
    for (name, rows), marker in zip(series.items(), MARKERS * len(series)):
        rows = sorted((number(x)[1], y) for x, y in rows)
        values = [y for _, y in rows]
        axes.errorbar([x for x, _ in rows], [y for _, y, _ in values], yerr=errors(values), marker=marker, ms=4, capsize=2,
                      label=name)
    places = sorted({number(x)[1] for rows in series.values() for x, _ in rows})
    if logarithmic(places, 4 if logarithmic(heights(series)) else SPAN):
        axes.set_xscale("log")
        if len(places) <= 8:
            axes.set_xticks(places, [f"{x:g}" for x in places])
            axes.set_xticks([], minor=True)


def draw_bars(axes, series):
    """Along the lines of a list, the first on top."""
    places = list(dict.fromkeys(x for rows in series.values() for x, _ in rows))
    bars = not logarithmic(heights(series)) and errors([y for rows in series.values() for _, y in rows]) is None
    width = 0.8 / len(series)
    for n, ((name, rows), marker) in enumerate(zip(series.items(), MARKERS * len(series))):
        at = [places.index(x) + (n - (len(series) - 1) / 2) * width for x, _ in rows]
        own = [y for _, y in rows]
        if bars:
            axes.barh(at, [y for _, y, _ in own], width, label=name)
        else:
            axes.errorbar([y for _, y, _ in own], at, xerr=errors(own), fmt=marker, ms=4, capsize=2, label=name)
    axes.set_yticks(range(len(places)), places, fontsize=8)
    axes.set_ylim(len(places) - 0.5, -0.5)
    axes.grid(axis="x", linewidth=0.3)
    return len(places) * max(0.25, 0.1 * len(series))


def draw(names, series):
    numeric = all(number(x) for rows in series.values() for x, _ in rows)
    figure, axes = pyplot.subplots(figsize=(8, 4), constrained_layout=True)
    if numeric:
        draw_lines(axes, series)
        axes.set(xlabel=names[0], ylabel=names[-1])
    else:
        figure.set_figheight(1 + draw_bars(axes, series))
        axes.set(xlabel=names[-1])
    if logarithmic(heights(series)):
        (axes.set_yscale if numeric else axes.set_xscale)("log")
    if len(series) > 1:
        axes.legend(title=names[1], fontsize=7, title_fontsize=7, loc="upper left", bbox_to_anchor=(1, 1))
    return figure


def charts(base, text):
    """(match, names, series) of each chart of a page."""
    return [(match, *points(base, match["query"])) for match in CHART.finditer(text)]


def drawn(base, page, text, folder):
    """The text of a page with pictures in the place of its comments; they are written into `folder`/charts."""
    for count, (match, names, series) in enumerate(charts(base, text), 1):
        file = Path(folder) / "charts" / f"{page.stem}-{count}.png"
        file.parent.mkdir(parents=True, exist_ok=True)
        figure = draw(names, series)
        figure.savefig(file, dpi=90)
        pyplot.close(figure)
        text = text.replace(match[0], f"![{match['caption']}](charts/{file.name})\n", 1)
    return text
