# SPDX-License-Identifier: BSD-3-Clause
"""Reads finished runs of the sheared discs and holds them against the thesis's findings.

A value is a pair (mean, standard error). Units: see in.shear."""

import math

import sweep

KINDS = ("collision", "approach", "escape", "capture", "kinetic")
# In the order of in.shear.
WATCHED = ("stress_xx", "stress_yy", "stress_xy", "size", "duration", "largest", "pairs", "temperature",
           "collisions", "dissipated",
           *(f"{kind}_{component}" for kind in KINDS for component in ("xx", "yy", "xy")))
SURE = 2.0  # standard errors by which a difference must stand out


def read_log(text):
    """Means with errors of all watched values, and how the run ended; dict."""
    lines = [line.split() for line in text.splitlines()]
    found = {int(words[1]): [float(words[2]), float(words[3])]
             for words in lines if len(words) == 4 and words[0] == "watched"}
    result = {name: found[k] for k, name in enumerate(WATCHED, 1)}
    for name in ("strain", "blocks", "stationary", "elastic"):
        result[name] = next(float(words[1]) for words in lines if len(words) == 2 and words[0] == name)
    result["box"] = next([float(words[1]), float(words[2])] for words in lines if words[:1] == ["box"])
    return result


class Results:
    """Finished runs by their settings."""

    def __init__(self, results):
        self.by_run = {sweep.Run(*(r["settings"][k] for k in sweep.Run._fields)): r for r in results}

    def curve(self, quantity, D, w=sweep.WIDTH, e=sweep.RESTITUTION):
        """Lists of area fractions, means and errors, at one depth."""
        rows = sorted((run.phi, *value(r, quantity)) for run, r in self.by_run.items()
                      if (run.D, run.w, run.e) == (D, w, e))
        return [list(column) for column in zip(*rows)]

    def at(self, quantity, phi, D, w=sweep.WIDTH, e=sweep.RESTITUTION):
        return value(self.by_run[sweep.Run(phi, D, w, e)], quantity)

    def run(self, phi, D, w=sweep.WIDTH, e=sweep.RESTITUTION):
        return self.by_run[sweep.Run(phi, D, w, e)]


def value(result, quantity):
    """normal: mean of xx and yy, errors as if they moved together."""
    if quantity == "normal":
        (a, da), (b, db) = result["stress_xx"], result["stress_yy"]
        return (a + b) / 2, (da + db) / 2
    return tuple(result[quantity])


def ratio(a, b):
    """a/b with its error."""
    r = a[0] / b[0]
    return r, abs(r) * math.hypot(a[1] / a[0], b[1] / b[0])


def rises(values):
    """Whether each value is above the one before by more than SURE errors: yes, no (one is below by as
    much), or unclear."""
    steps = [(b[0] - a[0]) / max(math.hypot(a[1], b[1]), 1e-300) for a, b in zip(values, values[1:])]
    if all(s > SURE for s in steps):
        return "agrees"
    return "differs" if any(s < -SURE for s in steps) else "cannot tell"


HARDLY = 0.1  # a change below this share is hardly one
LARGE = 0.1  # of all discs: an agglomerate of this size is no longer one of many


def transition(results, D):
    """Area fraction at which the largest agglomerate passes a tenth of all discs: (middle, half the
    distance) of the neighbouring runs below and above, and their largest fractions. None where all
    runs are on one side."""
    phi, mean, _ = results.curve("largest", D)
    for below, above, a, b in zip(phi, phi[1:], mean, mean[1:]):
        if a < LARGE <= b:
            return (below + above) / 2, (above - below) / 2, a, b
    return None


def show(v):
    """Mean and error, the error with two digits."""
    mean, error = v
    digits = max(0, 1 - math.floor(math.log10(error))) if error > 0 else 3
    return f"{mean:.{digits}f} +- {error:.{digits}f}"


def row(values):
    return ", ".join(show(v) for v in values)


def together(labels, verdicts):
    if len(set(verdicts)) == 1:
        return verdicts[0]
    return "in part (" + ", ".join(f"{label}: {v}" for label, v in zip(labels, verdicts)) + ")"


def findings(results):
    """The thesis's findings (chapter 4), each with (statement, figures, verdict)."""
    found = []

    def add(statement, figures, verdict):
        found.append((statement, figures, verdict))

    def along_depth(quantity, phi, depths):
        return [results.at(quantity, phi, D) for D in depths]

    def along_fraction(quantity, D):
        return list(zip(*results.curve(quantity, D)[1:]))

    def rise(statement, sets, sign=1):
        """sets: label and values in order; agrees when all of them rise (sign -1: fall)."""
        verdicts = [rises([(sign * m, e) for m, e in values]) for _, values in sets]
        add(statement, "; ".join(f"{label}: {row(values)}" for label, values in sets),
            together([label for label, _ in sets], verdicts))

    mild, strong = results.run(0.2, 4), results.run(0.5, 16)
    add("Two regimes: one large agglomerate, or mostly agglomerates of two",
        f"D 4, phi 0.2: largest {show(mild['largest'])} of all discs, pairs {show(mild['pairs'])} of all "
        f"agglomerates; D 16, phi 0.5: largest {show(strong['largest'])}, pairs {show(strong['pairs'])}",
        "agrees" if mild["pairs"][0] > 0.5 and strong["largest"][0] > 0.5 else "differs")
    for D in sweep.TRANSITION:
        at = transition(results, D)
        if at is None:
            add(f"Abrupt in phi, D {D}", "no transition between the fractions that were run", "differs")
            continue
        phi, half, below, above = at
        add(f"Abrupt in phi, D {D}",
            f"largest agglomerate passes a tenth of all discs at phi {phi:.4f} +- {half:.4f}: "
            f"{below:.3f} to {above:.3f} within {2 * half:.3f}",
            "agrees" if above > 5 * below else "differs")
    for quantity, name in (("normal", "Normal stress"), ("stress_xy", "Shear stress")):
        for phis, sign in (((0.4, 0.5), "falls"), ((0.1, 0.2), "hardly changes")):
            labels = [(phi, D) for phi in phis for D in sweep.MILD[-2:]]
            changes = [ratio(results.at(quantity, phi, D), results.at(quantity, phi, 0))
                       for phi, D in labels]
            right = [r + SURE * e < 1 if sign == "falls" else abs(r - 1) < HARDLY for r, e in changes]
            labels = [f"phi {phi}, D {D}" for phi, D in labels]
            add(f"{name} {sign} with D at phi {' and '.join(map(str, phis))}",
                "over D 0: " + "; ".join(f"{label}: {show(c)}" for label, c in zip(labels, changes)),
                together(labels, ["agrees" if r else "differs" for r in right]))
    depths = sweep.MILD[1:]
    rise("Collision part of tau_xx rises with D",
         [(f"phi {phi}", along_depth("collision_xx", phi, (0, *depths))) for phi in (0.3, 0.4)])
    for phi in (0.3, 0.4):
        gain = [results.at("collision_xx", phi, depths[-1])[0] - results.at("collision_xx", phi, depths[0])[0],
                results.at("capture_xx", phi, depths[-1])[0] - results.at("capture_xx", phi, depths[0])[0]]
        error = [math.hypot(results.at(f"{kind}_xx", phi, depths[-1])[1],
                            results.at(f"{kind}_xx", phi, depths[0])[1])
                 for kind in ("collision", "capture")]
        add(f"... while capture falls by more, phi {phi}",
            f"D {depths[0]} to {depths[-1]}: collision {gain[0]:+.3f} +- {error[0]:.3f}, capture "
            f"{gain[1]:+.3f} +- {error[1]:.3f}",
            "agrees" if -gain[1] > gain[0] + SURE * math.hypot(*error) else "differs")
    for quantity, name in (("duration", "Duration of agglomerates"), ("size", "Size")):
        rise(f"{name} grows with D",
             [(f"phi {phi}", along_depth(quantity, phi, depths)) for phi in (0.1, 0.3, 0.5)])
        falls = quantity == "duration"
        rise(f"{name} {'falls' if falls else 'grows'} with phi",
             [(f"D {D}", along_fraction(quantity, D)) for D in depths], -1 if falls else 1)
        rise(f"{name} grows with r_out/r",
             [(f"phi {phi}", [results.at(quantity, phi, sweep.WIDTHS_DEPTH, w) for w in sweep.WIDTHS])
              for phi in sweep.AT_WIDTHS])
    return found


def report(raw):
    """Text: what was run, and the findings."""
    results = Results(raw)
    met = sum(r["stationary"] for r in raw)
    elastic = max(raw, key=lambda r: r["elastic"])
    name = sweep.Run(*(elastic["settings"][k] for k in sweep.Run._fields)).name
    lines = [f"{len(raw)} runs, {met:.0f} of them ended by the block rule, the others by the limit of blocks; "
             f"{sum(r['seconds'] for r in raw):.0f} s in all",
             f"collisions made elastic by the rule against collapse: at most {100 * elastic['elastic']:.2g} % "
             f"({name})", "",
             f"D in m rate^2 r^2; r_out/r {sweep.WIDTH}, e {sweep.RESTITUTION} unless said; +- one standard "
             "error", ""]
    for statement, figures, verdict in findings(results):
        lines += [f"{statement}: {verdict.upper()}", f"    {figures}"]
    return "\n".join(lines)
