# SPDX-License-Identifier: BSD-3-Clause
"""Decides the claims of chapter 4 of the thesis by runs on its own parameters.

A value is a pair (mean, standard error). A change stands out when it exceeds SURE standard errors."""

import math

import analyse
import sweep
from analyse import HARDLY, SURE, ratio, row, show

DENSE, DILUTE = (0.4, 0.5), (0.1, 0.2)
COLLISIONAL = (0.3, 0.4, 0.5)
COLLISIONAL_TEN = (0.3, 0.5)  # of those, at D* 10
LEAST, *_, MOST = sweep.DEPTHS
ENDS = LEAST, MOST
FIFTH = 0.1, 0.3  # "roughly 20%"


class Runs:
    """Results by run. Runs that recorded events are stored separately."""

    def __init__(self, raw):
        self.plain, self.recorded = {}, {}
        for result in raw:
            run = sweep.Run(*(result["settings"][k] for k in sweep.Run._fields))
            (self.recorded if result["settings"]["record"] == "yes" else self.plain)[run] = result

    def at(self, quantity, phi, depth, w=1.001):
        return analyse.value(self.plain[sweep.starred(phi, depth, w)], quantity)

    def event(self, quantity, phi, w=1.001):
        return tuple(self.recorded[sweep.starred(phi, sweep.TEN, w)][quantity])

    def along(self, quantity, fractions, depths=(MOST,), widths=(1.001,)):
        return [self.at(quantity, phi, depth, w) for phi in fractions for depth in depths for w in widths]


def change(values):
    """From the first to the last."""
    (a, da), (b, db) = values[0], values[-1]
    return b - a, math.hypot(da, db)


def sign(difference):
    mean, error = difference
    return 0 if not abs(mean) > SURE * error else 1 if mean > 0 else -1


def overall(verdicts):
    """Of a claim about several sets: differs if one set differs, agrees if more than half agree, otherwise cannot
    tell."""
    if "differs" in verdicts:
        return "differs"
    return "agrees" if 2 * list(verdicts).count("agrees") > len(verdicts) else "cannot tell"


def trend(statement, sets, direction):
    """sets: label and values in order. From the first to the last each moves in the direction, by more than SURE
    errors."""
    signs = [direction * sign(change(values)) for _, values in sets]
    verdicts = [("cannot tell", "agrees", "differs")[s] for s in signs]
    texts = [f"{label}: {row(values)} ({verdict})" for (label, values), verdict in zip(sets, verdicts)]
    return statement, "; ".join(texts), overall(verdicts)


def agglomerates(runs):
    """Figs 4.4 and 4.5."""
    depths = [depth for depth in sorted([*sweep.DEPTHS, sweep.TEN]) if depth]
    for quantity, with_phi in (("duration", -1), ("size", 1)):
        yield trend(f"Fig. 4.4 {quantity} grows with D*",
                    [(f"phi {phi}", runs.along(quantity, [phi], depths)) for phi in sweep.TEN_AT], 1)
        yield trend(f"Fig. 4.4 {quantity} {'falls' if with_phi < 0 else 'grows'} with phi",
                    [(f"D* {depth}", runs.along(quantity, sweep.DEPTHS.get(depth, sweep.TEN_AT), [depth]))
                     for depth in depths], with_phi)
        held = [(f"held, phi {phi}", runs.along(quantity, [phi], [sweep.TEN], sweep.TEN_WIDTHS))
                for phi in sweep.TEN_AT]
        captured = [(f"captured, phi {phi}", [runs.event(f"captured_{quantity}", phi, w) for w in sweep.TEN_WIDTHS])
                    for phi in sweep.TEN_AT]
        # The thesis counts from capture to escape: those pairs decide. In wells of 1.001 held pairs are the same.
        yield trend(f"Fig. 4.5 {quantity} grows with r_out/r", captured, 1)
        yield trend(f"Fig. 4.5 {quantity} of held pairs, not decisive", held, 1)


def stress(runs):
    """Figs 4.6 to 4.11."""
    def over(quantity, phi):
        return ratio(runs.at(quantity, phi, MOST), runs.at(quantity, phi, LEAST))

    for quantity, figure in (("stress_xx", "4.6"), ("stress_yy", "4.6, yy"), ("stress_xy", "4.10")):
        yield trend(f"Fig. {figure}: {quantity} falls with D*",
                    [(f"phi {phi}", runs.along(quantity, [phi], ENDS)) for phi in DENSE], -1)
        ratios = [over(quantity, phi) for phi in DENSE + DILUTE]
        unchanged = [abs(r - 1) + SURE * e < HARDLY for r, e in ratios[len(DENSE):]]
        changed = [abs(r - 1) - SURE * e > HARDLY for r, e in ratios[len(DENSE):]]
        yield (f"Fig. {figure}: {quantity} hardly changes below phi 0.3",
               f"D* {MOST} over 0 at phi {', '.join(map(str, DENSE + DILUTE))}: {row(ratios)}",
               "agrees" if all(unchanged) else "differs" if any(changed) else "cannot tell")
    for component in ("xx", "xy"):
        yield from parts(runs, component)
    for quantity in ("stress_xx", "stress_yy"):
        yield trend(f"Fig. 4.9: {quantity} falls as r_out/r approaches 1",
                    [(f"phi {phi}", runs.along(quantity, [phi], [sweep.TEN], sweep.TEN_WIDTHS))
                     for phi in COLLISIONAL_TEN], 1)


def parts(runs, component):
    """Share of the kinds of events in the change of the stress from LEAST to MOST."""
    def gain(kind, phi):
        return change(runs.along(f"{kind}_{component}", [phi], ENDS))

    texts = {phi: "; ".join(f"{kind} {show(gain(kind, phi))}" for kind in analyse.KINDS) for phi in COLLISIONAL}
    text = " | ".join(f"phi {phi}, D* {LEAST} to {MOST}: {t}" for phi, t in texts.items())
    sets = [(f"phi {phi}", runs.along(f"collision_{component}", [phi], ENDS)) for phi in COLLISIONAL]
    if component == "xy":
        yield trend("Fig. 4.11: collision part of the shear stress becomes smaller", sets, -1)
        yield "Fig. 4.11: parts of the change", text, "not decisive"
        return
    shares = []
    for phi in DENSE:
        two = [gain(kind, phi) for kind in ("approach", "escape")]
        fall = (sum(gain(kind, phi)[0] for kind in analyse.KINDS if kind != "kinetic"),
                # The parts' own errors are far larger than that of their sum: events of a pair come together.
                math.hypot(*(runs.at("stress_xx", phi, depth)[1] for depth in (LEAST, MOST))))
        shares.append(ratio((two[0][0] + two[1][0], math.hypot(two[0][1], two[1][1])), fall))
    within = ["agrees" if FIFTH[0] < s - SURE * e and s + SURE * e < FIFTH[1] else
              "differs" if s + SURE * e < FIFTH[0] or s - SURE * e > FIFTH[1] else "cannot tell" for s, e in shares]
    yield ("Figs 4.7a, b: approach and escape make a fifth of the fall",
           f"phi {DENSE}: {row(shares)} {within} | {text}", overall(within))
    yield trend("Fig. 4.7c: collision part of tau_xx rises with D*", sets, 1)
    sums = []
    for phi in COLLISIONAL:
        (a, da), (b, db) = gain("collision", phi), gain("capture", phi)
        sums.append((a + b, math.hypot(da, db)))
    verdicts = [("cannot tell", "differs", "agrees")[sign(s)] for s in sums]
    yield ("Figs 4.7d, 4.8: capture falls by more than collision rises",
           f"sum of both at phi {COLLISIONAL}: {row(sums)}", overall(verdicts))


def orientations(runs):
    """Fig. 4.12."""
    shares = [[runs.event(f"{kind}_along_shear", phi) for phi in COLLISIONAL_TEN] for kind in ("free", "captured")]
    free, captured = ([sign((m - 0.5, e)) for m, e in of] for of in shares)
    verdicts = ["agrees" if (f, b) == (1, -1) else "differs" if f < 0 or b > 0 else "cannot tell"
                for f, b in zip(free, captured)]
    yield ("Fig. 4.12: most collisions of free discs along the shear, of captured pairs against it",
           f"share along the shear at phi {COLLISIONAL_TEN}: free {row(shares[0])}; captured {row(shares[1])}",
           overall(verdicts))


def report(raw):
    """Text: what was run, and the verdicts."""
    runs = Runs(raw)
    lines = [f"{len(raw)} runs, {sum(r['stationary'] for r in raw):.0f} of them ended by the block rule; "
             f"{sum(r['processor_seconds'] for r in raw):.0f} s of processor time; collisions made elastic: at most "
             f"{100 * max(r['elastic'] for r in raw):.2g} %",
             "e 0.9, r_out/r 1.001 unless said; stress in rho_s rate^2 r^2; +- one standard error", ""]
    for part in (agglomerates, stress, orientations):
        for statement, figures, verdict in part(runs):
            lines += [f"{statement}: {verdict.upper()}", f"    {figures}"]
    return "\n".join(lines)
