# SPDX-License-Identifier: BSD-3-Clause
"""Runs the points of the stability campaign and says what became of them.

Soft laws: every point is run at its step and, with scheme event, at a sixteenth of it. Compared: who is together at
the end, and all velocities, relative to the largest speed that the point has (of impact, from the attraction, from an
overlap at the start). Scheme event also against the closed form of a head-on impact. Hard laws: against an
event-driven program without time steps (event_driven_reference.py), and that once more with velocities changed in
the last digits, which tells how far round-off carries.

Verdicts: `right`: below the aim; `other outcome`: who is together differs; `wrong`: by what; `refused`; `crashed`;
`hangs`; `not judged`: no reference, or round-off alone decides. Aims: one contact without friction that has parted
1e-6; one still in contact (w dt)^2/8, since the velocity on the grid is the mean of those half a step before and
after; with friction or several contacts second order, (w dt)^2, at most 0.1. Sampled forces 0.1: what they are
used for. Hard 1e-9, or 100 times what round-off does.
"""
import math
import re
import subprocess
from collections import namedtuple
from pathlib import Path

import numpy

REFERENCE = 16
MOST_EVENTS = 400
SECONDS = 30
# verdicts, errors: by case; said: warnings about the run, short; exact: error of the energy of a head-on
# impact against the closed form.
Result = namedtuple("Result", "verdicts errors said exact")

SHORT = (("the overlap of a resting pair is ([^ ]*) %", r"resting overlap \1 %"),
         ("the largest overlap of an impact is ([^ ]*) %", r"impact overlap \1 %"),
         ("a contact takes ([^ ]*) time steps", r"\1 steps per contact"),
         ("crosses the surface cut-off in ([^ ]*) time steps", r"\1 steps in the cut-off"),
         ("crosses the well in ([^ ]*) time steps", r"\1 steps in the well"))
# About the material, or the engine's own: no warning that a number is wrong.
NO_WARNING = ("would stick less with a stiffer spring", "thermo_modify", "thermo_style")


def short(message):
    for long, brief in SHORT:
        found = re.search(long, message)
        if found:
            return found.expand(brief)
    return re.sub(r"^(pair_style|fix)[^:]*: ", "", re.sub(r" \(\S+:\d+\)", "", message))


def run(point, engine, scheme, finer):
    """State (ran, refused, crashed, hangs), what was said, and the end: places, velocities."""
    steps = max(1 if point.law.hard else 4, math.ceil(point.duration / point.dt * (1 - 1e-9)))
    skin = max(0.2 * point.radius[0], (4 if point.law.hard else 30) * point.dt * point.scale)
    with engine.temporary_folder() as folder:
        spheres = point.spheres()
        far = 2e-2 + 2 * skin + 2 * point.duration * point.scale + max(abs(x).max() for _, x, _ in spheres)
        low = 0.0 if point.law.wall else -far
        engine.write_spheres(folder, [{"type": 1 + kind, "diameter": 2 * point.radius[kind],
                                       "density": point.density[kind], "x": x, "v": v} for kind, x, v in spheres],
                             [(low, far), (low, far), (-far, far)], 2)
        (Path(folder) / "law.txt").write_text("\n".join(point.law.lines(point, scheme)) + "\n")
        try:
            code, output = engine.start("in.stability", folder, dt=point.dt / finer, steps=steps * finer,
                                        skin=float(skin), timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return "hangs", "", None
        said = [w for w in re.findall(r"WARNING: (.*)", output) if not any(no in w for no in NO_WARNING)]
        said = "; ".join(sorted({short(w) for w in said}))
        if code != 0:
            error = re.search(r"ERROR[^:]*: (.*)", output)
            return ("refused", short(error[1]), None) if error else ("crashed", output[-300:], None)
        end = engine.dump(folder, "end.txt")
    return "ran", said, (end[:, 1:4], end[:, 4:7])


def together(point, contacts, places):
    """For each contact whether its two are nearer than the edge; `places` by number of the sphere."""
    gap = point.law.outcome_gap(point)
    return [point.gap_of(places, contact) < gap for contact in contacts]


def judge(point, engine):
    state, said, end = run(point, engine, point.law.scheme, 1)
    if state != "ran":
        return Result({name: state for name in point.cases()}, {}, said, None)
    reference = hard_reference if point.law.hard else fine_run
    found = reference(point, engine)
    verdicts, errors = {}, {}
    for name, (spheres, contacts) in point.cases().items():
        if found.get(name) is None:
            verdicts[name] = "not judged"
            continue
        known, room = found[name]
        errors[name] = float(numpy.abs(end[1][spheres] - known[1]).max() / point.scale)
        held = together(point, contacts, end[0])
        same = held == together(point, contacts, dict(zip(spheres, known[0])))
        verdicts[name] = verdict(errors[name], same, room(held))
    exact = closed_form(point, end) if point.law.scheme == "event" else None
    if exact is not None and exact > 1e-6:
        verdicts["first"] = f"wrong: {exact:.1g} of the energy"
    return Result(verdicts, errors, said, exact)


def verdict(error, same, aim):
    if not math.isfinite(error):
        return "wrong: not a number"
    if not same:
        return "other outcome"
    return "right" if error < aim else f"wrong by {error:.1g}"


def fine_run(point, engine):
    """By case: places and velocities of its spheres, and the aim as a function of who is together."""
    state, _, end = run(point, engine, "event", REFERENCE)
    if state != "ran":
        return {}
    angle = math.pi / point.values["steps"]

    def room(name):
        def aim(held):
            if point.law.scheme == "sampled":
                return 0.1
            if name == "first" and not point.values["mu"]:
                return angle**2 / 8 if held[0] else 1e-6
            return min(angle**2, 0.1)
        return aim

    return {name: ((end[0][spheres], end[1][spheres]), room(name))
            for name, (spheres, _) in point.cases().items()}


def hard_reference(point, _):
    """As fine_run, from the event-driven program; None where it collapses, or round-off alone decides."""
    found = {}
    for name, (spheres, _) in point.cases().items():
        ends = [event_driven(point, spheres, change) for change in (0.0, 4e-15)]
        if any(end is None for end in ends):
            continue
        roundoff = 100 * numpy.abs(ends[0][1] - ends[1][1]).max() / point.scale
        if roundoff < 1e-3:
            found[name] = ends[0], lambda _, roundoff=roundoff: max(1e-9, roundoff)
    return found


def event_driven(point, spheres, change):
    from event_driven_reference import Plane, Reference
    p, wall = point.values, point.law.wall
    kinds, x, v = zip(*(point.spheres()[n] for n in spheres))
    ratio = 1 + point.wide / point.reach
    planes = [Plane(axis, 0.0, 1, p["e"], p["mu"], point.well, ratio) for axis in (0, 1)] if wall else []
    reference = Reference(numpy.array(x), numpy.array(v) * (1 + change * numpy.arange(3)),
                          [point.radius[k] for k in kinds], [point.mass[k] for k in kinds], 3 * [math.inf],
                          p["e"], p["mu"], 0.0 if wall else point.well, 1.0 if wall else ratio, planes=planes)
    duration = math.ceil(p["steps"] * (1 - 1e-9)) * point.dt
    reference.run(duration, MOST_EVENTS)
    if len(reference.events) >= MOST_EVENTS:
        return None
    return reference.place(duration), reference.v


def closed_form(point, end):
    """Error of the energy that a head-on impact leaves; None where it does not apply."""
    p = point.values
    if p["angle"] or p["mu"] or p["overlap"] or not p["speed"]:
        return None
    left, touch = point.law.head_on(point)
    # Else it may be on its way still.
    if point.gap > p["speed"] * point.contact or point.law.outcome_gap(point) == 0:
        return None
    velocity = end[1][0] if point.law.wall else end[1][1] - end[1][0]
    held = together(point, point.cases()["first"][1], end[0])[0]
    if left < 0:
        return 0.0 if held else 1.0
    return None if held else abs(velocity @ velocity / touch**2 - left)
