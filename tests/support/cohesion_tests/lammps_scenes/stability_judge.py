# SPDX-License-Identifier: BSD-3-Clause
"""Runs the points of the stability campaign and says what became of them.

Soft laws: every point is run at its step and, with scheme exact, at a sixteenth of it. Compared: who is together at
the end, and all velocities, relative to the largest speed s that the point has (of impact, from the attraction, from
an overlap at the start). While spheres are together the velocity on the grid, the mean of those half a step before
and after, jumps where they meet an edge; instead their places are compared, relative to s/w, w the frequency of a
contact; where only some are together, whichever is nearer. Scheme exact also against the closed form of a head-on
impact. Hard laws: against an event-driven program without time steps (event_driven_reference.py), and that twice
more with places and velocities changed in the last digits, which tells how far round-off carries.

Verdicts: `right`: below the aim; `other outcome`: who is together differs; `wrong`: by what; `refused`; `crashed`;
`hangs`; `marginal`: wrong, but both references whose speeds are changed by the aim (up and down, 0.1 at most) are as
far off; or of other outcome, and one of the two has the same, or, of scheme exact, what parts in one run alone does so
with less energy than speeds off by the aim change (barely_parted); `not judged`: no reference, or wrong where round-off
alone decides (rounding_decides) or where references of half and of twice the step do not agree with each other;
`reference crashed` (hangs, refused): one that would be needed to say. What is not a number is always `wrong`.
Aims: of Hertz's and JKR's contacts second order, (w dt)^2; of others one contact without friction 1e-6 once parted, and
of spheres by what angle their line of centres is off in a contact, up to u V dt^2/d^2 (docs/theory/exact_contacts.md),
and what their centrifugal force adds, which overlaps bear with K' (turning_load); with friction or several contacts
second order, (w dt)^2, and where a particle has several contacts with friction first order of the dashpot
(late_dashpot), at most 0.1 in all; while together also what the
place on the grid may differ from that of the motion, (w dt)^2/8, in wells w dt; and what the last digit of the largest
place is of s/w, times the number of steps. Where that is more than 0.1 the aim is 0.1, and what is off by more, but by
no more than that, is `not judged: coarse`. Where a sphere flies less than four such digits in a fine step nothing is
judged. Sampled forces 0.1: what they are used for. Hard 1e-9, or 100 times what round-off does.
"""
import math
import re
import subprocess
from collections import namedtuple
from pathlib import Path

import numpy

from cohesion_tests.brief_warnings import fits, short, warnings

REFERENCE = 16
MOST_EVENTS = 400
SECONDS = 120  # far above what a run takes, on a busy machine too
# verdicts, errors: by case; said: warnings about the run, short; exact: error of the energy of a head-on
# impact against the closed form.
Result = namedtuple("Result", "verdicts errors said exact")

# Largest error that counts as right, over the largest speed.
MOST = 0.1
# Below `right` a case is right; from there to `room` it has no verdict.
Aim = namedtuple("Aim", "right room")
NOT_A_NUMBER = "wrong: not a number"
COARSE = "not judged: coarse"
GOOD = ("right", "marginal", "not judged", "refused")


def kind(verdict, said):
    """What a verdict counts as: itself, or wrong with what fits() says of the warnings."""
    if verdict in GOOD:
        return verdict
    if verdict == COARSE:
        return "not judged"
    if verdict in ("crashed", "hangs") or verdict.startswith("reference "):
        return "crashed"
    return fits(said)


def run(point, engine, scheme, finer, faster=0.0):
    """State (ran, refused, crashed, hangs), messages, and the end: places, velocities. All speeds are
    `faster` larger than the point's, by a share."""
    steps = max(1 if point.law.hard else 4, math.ceil(point.duration / point.dt * (1 - 1e-9)))
    skin = max(0.2 * point.radius[0], (4 if point.law.hard else 30) * point.dt * point.scale)
    with engine.temporary_folder() as folder:
        spheres = point.spheres()
        far = 2e-2 + 2 * skin + 2 * point.duration * point.scale + max(abs(x).max() for _, x, _ in spheres)
        low = 0.0 if point.law.wall else -far
        engine.write_spheres(folder, [{"type": 1 + kind, "diameter": 2 * point.radius[kind],
                                       "density": point.density[kind], "x": x, "v": v * (1 + faster)}
                                      for kind, x, v in spheres],
                             [(low, far), (low, far), (-far, far)], 2)
        (Path(folder) / "law.txt").write_text("\n".join(point.law.lines(point, scheme)) + "\n")
        try:
            code, output = engine.start("in.stability", folder, dt=point.dt / finer, steps=steps * finer,
                                        skin=float(skin), timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return "hangs", "", None
        said = warnings(output, point.touching)
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
    state, known = (hard_reference if point.law.hard else fine_run)(point, engine)
    if state in ("crashed", "hangs"):
        return Result({name: f"reference {state}" for name in point.cases()}, {}, said, None)
    verdicts, errors, others = {}, {}, {}
    for name in point.cases():
        if name not in known:
            verdicts[name] = "not judged"
            continue
        aim = known[name][1](held_at_all(point, name, end))
        errors[name], verdicts[name] = compare(point, name, end, known[name][0], aim)
        if verdicts[name] not in ("right", COARSE) and not point.law.hard:
            verdicts[name] = doubted(point, engine, name, end, known[name][0], aim.right, verdicts[name], others)
    exact = closed_form(point, end) if point.law.scheme == "exact" else None
    # Relative to the energy, and so twice what rounding of places does to the speed.
    if exact is not None and exact > 1e-6 + 2 * last_digit(end) * point.w0 / point.scale * point.duration / point.dt:
        verdicts["first"] = f"wrong: {exact:.1g} of the energy"
    return Result(verdicts, errors, said, exact)


def doubted(point, engine, name, end, known, aim, verdict, others):
    """The verdict on a case that is not right, after all that could excuse it. `aim`: below which it were right;
    `others`: ends of further references of the point, made when first asked for."""
    def reference(finer, faster=0.0):
        if (finer, faster) not in others:
            others[finer, faster] = run(point, engine, "exact", finer, faster)
        return others[finer, faster]

    change = min(aim, MOST)
    if verdict == NOT_A_NUMBER:
        return verdict
    if rounding_decides(point, known):
        return "not judged"
    if marginal(point, name, end, known, [reference(REFERENCE, sign * change)[2] for sign in (-1, 1)]):
        return "marginal"
    exact = point.law.scheme == "exact"
    if exact and verdict == "other outcome" and barely_parted(point, name, end, known, change):
        return "marginal"
    found = set()
    for state, _, other in (reference(finer) for finer in (REFERENCE // 2, 2 * REFERENCE)):
        if state != "ran":
            return f"reference {state}"
        found.add(compare(point, name, other, known, up_to(aim / 2))[1])
    if NOT_A_NUMBER in found:
        return NOT_A_NUMBER
    return verdict if found == {"right"} else "not judged"


def rounding_decides(point, end):
    """Whether an attraction of about m s w, over the last digit of a place, changes the energy by as much as there is
    in the approach, and as an impact takes: with it goes who escapes."""
    p = point.values
    approach = p["speed"] * math.cos(math.radians(p["angle"]))
    digit = 2 * point.scale * point.w0 * last_digit(end)
    return 0 < approach**2 < digit and (1 - p["e"]**2) * point.scale**2 < digit


def marginal(point, name, end, known, others):
    """Whether the case, which is not right, is as sensitive as that; `others`: ends of the changed references, None
    where one did not run, which excuses nothing. An outcome changes on one side of a threshold only."""
    error, found = compare(point, name, end, known, up_to(0.0))
    others = [other for other in others if other is not None]
    if found == "other outcome":
        return any(compare(point, name, end, other, up_to(0.0))[1] not in (found, NOT_A_NUMBER) for other in others)
    return len(others) == 2 and all(compare(point, name, other, known, up_to(error))[1] not in ("right", NOT_A_NUMBER)
                                    for other in others)


def barely_parted(point, name, end, known, aim):
    """Whether all that parted in one of the two runs alone did so with less energy than a speed s that is off by `aim`
    changes: v^2 below 2 aim s^2."""
    contacts = point.cases()[name][1]
    for contact, now, then in zip(contacts, together(point, contacts, end[0]), together(point, contacts, known[0])):
        if now != then and point.rate_of(*(known if now else end), contact)**2 > 2 * aim * point.scale**2:
            return False
    return True


def held_at_all(point, name, end):
    return any(together(point, point.cases()[name][1], end[0]))


def compare(point, name, end, known, aim):
    """Error and verdict of one case; `end`, `known`: places and velocities of all spheres."""
    spheres, contacts = point.cases()[name]
    held = together(point, contacts, end[0])
    same = held == together(point, contacts, known[0])
    away = [float(numpy.abs(mine[spheres] - theirs[spheres]).max()) for mine, theirs in zip(end, known)]
    error = away[1] / point.scale
    if any(held) and not point.law.hard:
        error = away[0] * point.w0 / point.scale if all(held) else min(error, away[0] * point.w0 / point.scale)
    return error, verdict(error, same, aim)


def up_to(error):
    return Aim(error, error)


def verdict(error, same, aim):
    if not math.isfinite(error):
        return NOT_A_NUMBER
    if not same:
        return "other outcome"
    if error < aim.right:
        return "right"
    return COARSE if error < aim.room else f"wrong by {error:.1g}"


def last_digit(end):
    """Of the largest place [m]."""
    return numpy.finfo(float).eps * numpy.abs(end[0]).max()


def fine_run(point, engine):
    """State, and by case: places and velocities of all spheres, and the aim, which depends on whether any are
    together."""
    state, _, end = run(point, engine, "exact", REFERENCE)
    if state != "ran":
        return state, {}
    p = point.values
    angle = math.pi / p["steps"]
    digit = last_digit(end)
    # What no engine can move on the fine grid.
    if 0 < p["speed"] * math.cos(math.radians(p["angle"])) * point.dt / REFERENCE < 4 * digit:
        return state, {}
    # What the line of centres of two spheres may be off by after a contact; that of a wall stays.
    across = p["speed"] * math.sin(math.radians(p["angle"]))
    turning = 0.0
    if not point.law.wall and not is_integrated(point):
        turning = point.scale * across * (point.dt / point.reach)**2 + turning_load(point, across)
    roundoff = digit * point.w0 / point.scale * point.duration / point.dt * REFERENCE

    def aim(name):
        if point.law.scheme == "sampled":
            return lambda held: up_to(MOST)
        if name == "first":
            alone = angle**2 if p["mu"] or is_integrated(point) else 1e-6 + turning
        else:
            alone = angle**2 + late_dashpot(point)
        alone = min(alone, MOST)

        def of(held):
            # The motion is off by the one, its place on the grid by the other besides.
            room = alone + (point.law.place_room(point) if held else 0.0) + roundoff
            return Aim(min(room, MOST), room)
        return of

    return state, {name: (end, aim(name)) for name in point.cases()}


def is_integrated(point):
    """Whether the law has no closed form; a contact's error is of second order then."""
    return "E" in point.values


def damping_ratio(restitution):
    return 1.0 if restitution == 0 else -math.log(restitution) / math.hypot(math.pi, math.log(restitution))


def turning_load(point, across):
    """Error after a contact without friction that turns with the speed `across`, over s.

    The centrifugal acceleration b = across^2/d shifts the overlap about which a contact oscillates by b/w^2, but by
    (K/K') b/w^2 on the grid. With the difference `shift` a pair that came at v and would leave at u leaves later, by
    `late` = shift (1 + e)/u, and is slower by what the dashpot and the pull F_ad decelerate it by then, 2 alpha u +
    F_ad/mu. Until then the line of centres turns by late across/d, and with it all of the speed. u = e v - 2 alpha
    (1 + e) F_ad/K, since the pull shifts the overlap, too. Where that is nothing, there is no bound."""
    p, d = point.values, point.reach
    if across == 0.0:
        return 0.0
    damping, pull = damping_ratio(p["e"]), getattr(point, "force", 0.0)
    alpha, phase = damping * point.w0, math.sqrt(1 - damping**2) * point.w0 * point.dt
    decay = math.exp(-alpha * point.dt)
    softer = (point.w0 * point.dt)**2 / (1 + decay**2 - 2 * decay * math.cos(phase)) - 1
    shift = softer * across**2 / d / point.w0**2
    along = math.sqrt((p["speed"] * math.cos(math.radians(p["angle"])))**2 + 2 * point.well / point.mu)
    leaves = p["e"] * along - 2 * alpha * (1 + p["e"]) * pull / p["K"]
    if leaves <= 0.0:
        return MOST
    late = shift * (1 + p["e"]) / leaves
    error = late * (2 * alpha * leaves + pull / point.mu + across / d * math.hypot(along, across))
    return min(error / point.scale, MOST)


def late_dashpot(point):
    """Error of a particle with several contacts with friction, over s. The force eta v of a dashpot begins and ends at
    once, and friction carries at most its share mu to the other contacts, whose load is that of the step before: an
    impulse of mu eta v dt, 2 mu zeta w dt of the momentum."""
    p = point.values
    return 2 * min(p["mu"], 1.0) * damping_ratio(p["e"]) * math.pi / p["steps"]


def hard_reference(point, _):
    """As fine_run, from the event-driven program; without cases that collapse, or that round-off alone decides."""
    found = {}
    for name, (spheres, _) in point.cases().items():
        ends = [event_driven(point, spheres, change) for change in (0.0, 4e-15, -4e-15)]
        if any(end is None for end in ends):
            continue
        roundoff = 100 * max(numpy.abs(ends[0][1] - end[1])[spheres].max() for end in ends[1:]) / point.scale
        if roundoff < 1e-3:
            found[name] = ends[0], lambda held, roundoff=roundoff: up_to(max(1e-9, roundoff))
    return "ran", found


def event_driven(point, spheres, change):
    """Places and velocities of all spheres, of which those not in `spheres` fly on; None when it collapses."""
    from cohesion_tests.theory.event_driven_reference import Plane, Reference
    p, wall = point.values, point.law.wall
    kinds, x, v = map(list, zip(*point.spheres()))
    random = numpy.random.default_rng(1)
    x = numpy.array(x) + change * point.reach * random.normal(size=(len(x), 3))
    v = numpy.array(v) * (1 + change * random.normal(size=(len(v), 3)))
    ratio = 1 + point.wide / point.reach
    planes = [Plane(axis, 0.0, 1, p["e"], p["mu"], point.well, ratio) for axis in (0, 1)] if wall else []
    reference = Reference(x[spheres], v[spheres], [point.radius[kinds[n]] for n in spheres],
                          [point.mass[kinds[n]] for n in spheres], 3 * [math.inf], p["e"], p["mu"],
                          0.0 if wall else point.well, 1.0 if wall else ratio, planes=planes)
    duration = math.ceil(p["steps"] * (1 - 1e-9)) * point.dt
    reference.run(duration, MOST_EVENTS)
    if len(reference.events) >= MOST_EVENTS:
        return None
    x, v = x + v * duration, v.copy()
    x[spheres], v[spheres] = reference.place(duration), reference.v
    return x, v


def closed_form(point, end):
    """Error of the energy that a head-on impact leaves; None where it does not apply."""
    p = point.values
    if is_integrated(point) or p["angle"] or p["mu"] or p["overlap"] or not p["speed"]:
        return None
    left, touch = point.law.head_on(point)
    # Else it may be on its way still.
    if point.gap > p["speed"] * point.contact:
        return None
    velocity = end[1][0] if point.law.wall else end[1][1] - end[1][0]
    held = together(point, point.cases()["first"][1], end[0])[0]
    if left < 0:
        return 0.0 if held else 1.0
    return None if held else abs(velocity @ velocity / touch**2 - left)
