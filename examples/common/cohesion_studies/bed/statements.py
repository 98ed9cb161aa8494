# SPDX-License-Identifier: BSD-3-Clause
"""Statements of M. Weber's thesis on cohesive beds (chapters 6 to 8), compared with the beds of the studies: a table of
the statements, each with the means over the seeds, their standard errors, and a verdict by the rule of verdict.py."""

from collections import namedtuple

from cohesion_studies.bed.verdict import Claim, above, alike, less_than_half, together, trend

LEVELS = ("1e-11", "5e-11", "1e-10")  # depth of the wells [J]; Hamaker's attraction of the same escape velocity
LAWS = {"well": "square well", "hamaker": "Hamaker"}
VELOCITIES = {"U_mf_df": "U_mf,df", "U_mf_th": "U_mf,th", "U_mf_in": "U_mf,in"}
SCHEMES = {"": "exact", "-sampled": "sampled"}
WIDTHS = {"-40": 40.0, "": 80.0, "-120": 120.0}  # [mm]

Statement = namedtuple("Statement", "text figure rows claims")  # rows: those whose figures stand beside it


def without(law, suffix):
    """Row without cohesion that has the contacts of the law's rows: with scheme sampled those of Hamaker's attraction
    are LAMMPS's own."""
    return "none-well-sampled" if (law, SCHEMES[suffix]) == ("well", "sampled") else f"none{suffix}"


def by_level(law, suffix):
    """Rows of a law, from no cohesion to the most."""
    return [without(law, suffix), *(f"{law}-{level}{suffix}" for level in LEVELS)]


def rises_with_escape_velocity(study, figure, law, suffix, text, sign=1):
    rows = by_level(law, suffix)
    return Statement(f"{text}, {LAWS[law]}, {SCHEMES[suffix]}", figure, rows,
                     trend(figure, {row: study.number(row, "v_esc") for row in rows}, sign))


def of_levels(study):
    """Chapter 7 and figure 8.21, with the exact scheme and with that of the thesis, and the influence of the scheme.
    That mixing slows and movement falls is not in the thesis, but that both are alike for both laws is."""
    found = []
    for suffix in SCHEMES:
        for figure, name in VELOCITIES.items():
            found += [rises_with_escape_velocity(study, figure, law, suffix, f"{name} rises with v_esc")
                      for law in LAWS]
            for level in LEVELS:
                pair = [f"{law}-{level}{suffix}" for law in LAWS]
                found.append(Statement(f"{name} alike for both laws, D = {level} J, {SCHEMES[suffix]}", figure, pair,
                                       alike(figure, *pair, *(without(law, suffix) for law in LAWS))))
        for figure, text in (("mixing", "mixing slows with v_esc"), ("movement", "movement falls with v_esc")):
            found += [rises_with_escape_velocity(study, figure, law, suffix, text, -1) for law in LAWS]
            for level in LEVELS:
                pair = [f"{law}-{level}{suffix}" for law in LAWS]
                found.append(Statement(f"{figure} alike for both laws, D = {level} J, {SCHEMES[suffix]}", figure, pair,
                                       alike(figure, *pair, *(without(law, suffix) for law in LAWS), sense=-1)))
        found += [rises_with_escape_velocity(study, "overshoot", law, suffix, "overshoot rises with v_esc")
                  for law in LAWS]
        for law in LAWS:
            none, low, _, high = by_level(law, suffix)
            found.append(Statement(f"plugs at D = {LEVELS[-1]} J and its like, {LAWS[law]}, {SCHEMES[suffix]}",
                                   "plugging", [none, low, high],
                                   [*above("plugging", high, none), *above("plugging", high, low)]))
    for figure, name in VELOCITIES.items():
        for law in LAWS:
            for level in LEVELS:
                pair = [f"{law}-{level}{suffix}" for suffix in SCHEMES]
                found.append(Statement(f"{name} alike for both schemes, {LAWS[law]}, D = {level} J or its like", figure,
                                       pair, alike(figure, *pair, *(without(law, suffix) for suffix in SCHEMES))))
    return found


# Places where cohesion is switched off, and the claims about them.
PLACES = {"particles": "particles add to", "plate": "the plate adds to", "side": "the side walls add to"}
MATTERS = {"well": ("plate", "side"), "hamaker": ("side", "plate")}  # which wall more, and the other
# The pressure maximum above the weight, as in the thesis; and above the bubbling bed's own pressure, which the plate
# leaves a little below the weight.
OVERSHOOTS = {"overshoot": "overshoot", "overshoot_over_plateau": "overshoot over the plateau"}


def of_mechanisms(_):
    """Chapter 8."""
    found = []
    for figure, words in OVERSHOOTS.items():
        for law, name in LAWS.items():
            claims = above(figure, law, "none")
            if figure == "overshoot":
                claims.append(Claim(figure, {law: 1.0}))
            found.append(Statement(f"{words} with cohesion, {name}", figure, [law, "none"], claims))
    for none, friction in (("none", 0.3), ("none-friction", 1.0)):
        found.append(Statement(f"no overshoot without, mu = {friction}", "overshoot", [none],
                               [Claim("overshoot", {none: -1.0})]))
        for law, name in LAWS.items():
            figure = "overshoot_over_plateau"
            found.append(Statement(f"over the plateau less than half of that with cohesion, mu = {friction}, {name}",
                                   figure, [none, law], [Claim(figure, {law: 0.5, none: -1.0})]))
    over = "overshoot"
    for law, name in LAWS.items():
        for place, words in PLACES.items():
            found.append(Statement(f"{words} the overshoot, {name}", over, [law, f"{law}-no-{place}"],
                                   above(over, law, f"{law}-no-{place}")))
        more, less = (f"{law}-no-{place}" for place in MATTERS[law])
        found.append(Statement(f"{PLACES[MATTERS[law][0]]} it more than the other walls, {name}", over, [less, more],
                               above(over, less, more)))
    (well, hamaker, none) = ({f"{row}{suffix}": width for suffix, width in WIDTHS.items()}
                             for row in ("well", "hamaker", "none"))
    falls = trend(over, hamaker, -1)
    found.append(Statement("overshoot falls with width, Hamaker", over, list(hamaker), falls))
    found.append(Statement("less than half as much without cohesion", over, list(none),
                           less_than_half(over, trend(over, none), falls)))
    found.append(Statement("less than half as much, square well", over, list(well),
                           less_than_half(over, trend(over, well), falls)))
    return found


def shown(study, row, figure):
    found = study.with_error(row, figure)
    if found is None:
        return f"{row}: unknown"
    value, error = found
    seeds = study.number(row, "seeds")
    return f"{row}: {value:.3g} " + ("" if seeds < 2 else f"+- {error:.1g} ") + f"({seeds:.0f})"


def table(statements, study):
    """As Markdown."""
    lines = ["| statement | mean +- standard error (seeds) | verdict |", "|---|---|---|"]
    for statement in statements:
        figures = "; ".join(shown(study, row, statement.figure) for row in statement.rows)
        lines.append(f"| {statement.text} | {figures} | {together(statement.claims, study)} |")
    return "\n".join(lines)
