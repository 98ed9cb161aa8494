# SPDX-License-Identifier: BSD-3-Clause
"""What is said of the rows of run.py: means over their seeds, theory beside them, and what several rows say together."""

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


def together(found, table):
    """Rows more, of several."""
    said = limits(found, table)
    for e in sorted({row["e"] for row in table.values()} - {1}):
        pairs = [(found[f"hard-{row['phi']:g}"], found[f"hard-{row['phi']:g}-e-{e:g}"], row["phi"])
                 for name, row in table.items() if name == f"hard-{row['phi']:g}-e-{e:g}"]
        for elastic, inelastic, phi in pairs:
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
