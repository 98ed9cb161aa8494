# SPDX-License-Identifier: BSD-3-Clause
"""Report on the rows of run.py: means over their seeds, theory beside them, and what several rows say together."""

import math
import statistics

import numpy as np

import theory
from cohesion_studies import study_table

WELLS = "plane"  # names of rows that the law of cohesion is fitted to begin so


def over(found, name, reference, called="over"):
    """The figure over a reference."""
    found[f"{name}_{called}"] = found[name] / reference
    found[f"{name}_{called}_error"] = found[f"{name}_error"] / reference


def of_seeds(results):
    """Means; the errors are those of the blocks of all, or of the seeds where these differ by more."""
    means = {name: mean for name, (mean, _) in study_table.over_seeds(results).items()}
    number = len(results)
    for name in [name for name in means if f"{name}_error" in means]:
        of_blocks = math.sqrt(sum(result[f"{name}_error"]**2 for result in results)) / number
        of_runs = statistics.stdev(r[name] for r in results) / math.sqrt(number) if number > 2 else 0.0
        means[f"{name}_error"] = max(of_blocks, of_runs)
    means["seconds"] = sum(result["processor_seconds"] for result in results)
    means.pop("processor_seconds", None)
    return means


def beside_theory(found, row):
    """Adds what theory has for a row."""
    phi, e = row["phi"], row["e"]
    if row["script"] == "flow":
        return
    if row["lattice"] == "fcc":
        over(found, "y", theory.crystal(phi))
        found["y_over_fluid"] = found["y"] / theory.y_of(theory.ma_ahmadi, min(phi, 0.64))
        return
    if row["A"]:
        b = theory.hamaker(row["K"], row["A"], row["Hc"], row["Ho"], row["scheme"] == "sampled")
        found["b"] = b
        over(found, "y", theory.y_of(theory.carnahan_starling, phi), "over_cs")
        return
    seen = phi * found["diameter"]**3 if row["script"] == "soft" else phi
    over(found, "y", theory.y_of(theory.ma_ahmadi, seen, e))
    over(found, "y", theory.y_of(theory.carnahan_starling, seen, e), "over_cs")
    if "y_events" in found and row["D"] == 0 and row["e"] == 1:
        found["events_over_virial"] = found["y_events"] / found["y"]
    if "y_events" in found and row["D"] == 0:
        over(found, "y_events", theory.y_of(theory.ma_ahmadi, phi))
    if row["D"]:
        found["b"] = theory.well(row["w"], row["D"])


def rows(kinds, table):
    """{row: figures}; `kinds`: results of each row."""
    found = {}
    for name, results in kinds.items():
        found[name] = of_seeds(results)
        beside_theory(found[name], table[name])
    return found


def limits(found, table):
    """y/y_HS of no spheres, on the straight line through two rows of few of which the one is denser; b beside it."""
    said = {}
    for name, row in table.items():
        base, _, phi = name.rpartition("-")
        others = [other for other in table if other != name and other.rpartition("-")[0] == base
                  and table[other]["phi"] > row["phi"]]
        if not base.startswith(("well", "hamaker")) or not others:
            continue
        thin, dense = found[name], found[others[0]]
        share = row["phi"] / (table[others[0]]["phi"] - row["phi"])
        limit = (1 + share) * thin["y_over_cs"] - share * dense["y_over_cs"]
        error = math.hypot((1 + share) * thin["y_over_cs_error"], share * dense["y_over_cs_error"])
        said[f"{base} limit"] = {"limit": limit, "limit_error": error, "b": thin["b"], "limit_over": limit / thin["b"],
                                 "limit_over_error": error / thin["b"]}
    return said


def depth_of(row):
    """X = (w^3 - 1)(exp(D) - 1), what the second virial coefficient of wells lacks of 1."""
    return (row["w"]**3 - 1) * math.expm1(row["D"])


def terms(phi, X):
    return [np.ones_like(X), phi, phi**2, phi * X]


def fit(found, table, e):
    """Coefficients of the law of cohesion at a restitution,

        y over (1 + e)/2 of hard spheres without wells = 1 - X (c_0 + c_1 phi + c_2 phi^2 + c_3 phi X),

    by least squares over the rows that are there, each by its error and half a per cent; c_0 is 1 for elastic spheres, whose
    limit of few is known. Beside them the root of the mean square of what is left, and the most of it. None of fewer than
    six rows."""
    rows = [(row, found[name]) for name, row in table.items() if name.startswith(WELLS) and row["e"] == e]
    if len(rows) < 6:
        return None
    phi, X = (np.array(column, float) for column in zip(*[(row["phi"], depth_of(row)) for row, _ in rows]))
    r, errors = (np.array([f[key] for _, f in rows]) for key in ("y_over_cs", "y_over_cs_error"))
    columns, known = np.array(terms(phi, X)).T * X[:, None], 1 - r
    free = slice(1, None) if e == 1 else slice(0, None)
    if e == 1:
        known = known - X
    weights = 1 / np.hypot(errors, 0.005)
    best = np.linalg.lstsq(columns[:, free] * weights[:, None], known * weights, rcond=None)[0]
    left = known - columns[:, free] @ best
    c = [1.0, *best] if e == 1 else list(best)
    return {**{f"c_{k}": float(value) for k, value in enumerate(c)}, "left": float(np.sqrt(np.mean(left**2))),
            "most_left": float(abs(left).max()), "error": float(np.sqrt(np.mean(errors**2)))}


def cohesive(law, phi, D, w):
    """Of fit()."""
    X = depth_of({"w": w, "D": D})
    return 1 - X * sum(law[f"c_{k}"] * term for k, term in enumerate(terms(np.asarray(phi), np.full_like(phi, X))))


def together(found, table):
    """Rows more, of several."""
    said = limits(found, table)
    for e in (1, 0.9):
        law = fit(found, table, e)
        if law:
            said[f"plane e {e} law"] = law
    for e in sorted({row["e"] for row in table.values()} - {1}):
        pairs = [(found.get(f"hard-{row['phi']:g}"), found[f"hard-{row['phi']:g}-e-{e:g}"])
                 for name, row in table.items() if name == f"hard-{row['phi']:g}-e-{e:g}"]
        for elastic, inelastic in pairs:
            if not elastic:
                continue
            inelastic["over_elastic"] = inelastic["y"] / elastic["y"] / ((1 + e) / 2)
            inelastic["over_elastic_error"] = math.hypot(inelastic["y_error"] / inelastic["y"],
                                                         elastic["y_error"] / elastic["y"])
    for name, row in table.items():
        hard = found.get(f"hard-{row['phi']:g}-e-{row['e']:g}")
        if row["script"] == "soft" and row["e"] < 1 and hard:
            found[name]["over_hard"] = found[name]["y_over_cs"] / hard["y_over_cs"]
    return said


def text(found):
    """A block for each row."""
    return "\n".join(f"{name:26s}" + "  ".join(f"{key} {value:.4g}" for key, value in row.items())
                     for name, row in found.items())
