# SPDX-License-Identifier: BSD-3-Clause
"""The cohesion models at the ends of their parameters, through LIGGGHTS: two spheres that meet head-on, a sphere and
a wall, and a sphere that strikes two that touch.

hooke/stiffness without friction, six contact times (of the undamped spring) and the flight through a well, or into
contact: a cut-off that takes longer than a contact time to fly through is entered on the way. Pair and wall are
compared with the closed form: which pairs stick, and the energy that is left over, with which a speed is worked out. Three
spheres are compared with a run at a sixteenth of the step: which pairs stick, and all velocities; a run whose step is so small
that it warns of rounded places is no reference. Errors are relative to the largest speed that the point has: of impact,
from the attraction, F_ad/sqrt(mu K).

Three spheres may turn round or part a little later than in the reference, and differ between the two turns alone. All
are compared at two times, the end and half a contact time later, and are wrong where they are so at both.
extremes_page.py writes the page.

Points are the same in both schemes. Verdicts: `right` below 0.1, what sampled forces are used for; `wrong, warned`:
other, and the run warned of a contact that occurs: the step is too large for the contact, the cut-off or the well, or
too small for rounded places;
`wrong, other types warned`: it said so only of contacts that do not occur, named in brackets;
`wrong, silent`: it did not; `refused`; `crashed` or `hangs`; `not set up`: of an overlap at the start, or where two
that touch would overlap by half a radius; `no reference`; `reference` with what became of it. Of an overlap at the
start is asked that no energy is gained.
"""
import math
import re
import subprocess
import tempfile
from pathlib import Path

import numpy

from cohesion_tests import dumps, launcher
from cohesion_tests.brief_warnings import ROUNDED, fits, of_own, short, warnings
from cohesion_tests.liggghts_scenes.extremes_points import ALL, DENSITY, INTEGRATED, RADIUS, partners

AIM, FINER = 0.1, 16
SECONDS = 120  # far above what a run takes, on a busy machine too
# From the end to where triples are looked at again, in contact times.
LATER = 0.5
SCHEMES = ("exact", "sampled")
CASES = ("pair", "wall", "three spheres")
# Right at the end, and later.
ONCE = {(True, False): ", later not", (False, True): ", later alone"}
SILENT = "wrong, silent"
WRONG = {"warned": "wrong, warned", "elsewhere": "wrong, other types warned", "silent": SILENT}
KINDS = ("right", *WRONG.values(), "refused", "crashed", "hangs")

SCRIPT = """units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region box block {box} units box
create_box 2 box
neighbor {skin:.17g} nsq
neigh_modify delay 0
{spheres}{properties}
fix e all property/global coefficientFriction peratomtypepair 2 0 0 0 0
pair_style gran {models}
pair_coeff * *
{wall}fix move all nve/sphere
timestep {dt:.17g}
thermo 1000000
{dumps}run {last}
"""
DUMP = """dump {name} all custom {step} {name}.txt id x y z vx vy vz
dump_modify {name} format "%d %.17g %.17g %.17g %.17g %.17g %.17g" sort id
"""


def matrix(name, *values):
    one, both, other = values if len(values) == 3 else 3 * values
    return (f"fix {name} all property/global {name} peratomtypepair 2 {one:.17g} {both:.17g} {both:.17g} "
            f"{other:.17g}\n")


def contacts(law, scheme, two, dampings):
    """What follows `pair_style gran` and a wall's shape, and the properties."""
    p, cohesion = two.values, law.split()[0]
    text = ""
    if law in INTEGRATED:
        models = f"model hertz tangential off cohesion {cohesion}"
        # Moduli above 1e9 Pa need it.
        text = ("hard_particles yes\n"
                f"fix E all property/global youngsModulus peratomtype {p['E']:.17g} {p['E']:.17g}\n"
                "fix nu all property/global poissonsRatio peratomtype 0.3 0.3\n"
                + matrix("coefficientRestitution", p["e"]))
    else:
        models = f"model hooke/stiffness tangential off cohesion {cohesion}"
        text = ("".join(matrix(name, p["K"]) for name in ("kn", "kt")) + matrix("gamman", *dampings)
                + matrix("gammat", 0.0))
    if law == "jkr":
        return models, "", text + matrix("surfaceEnergy", p["gamma"])
    if cohesion == "hamaker":
        return models, f" scheme {scheme}", text + (
            matrix("hamakerConstant", p["A"])
            + f"fix c all property/global hamakerSurfaceCutoff scalar {p['cut']:.17g}\n"
            f"fix o all property/global hamakerOuterCutoff scalar {100 * p['cut']:.17g}\n")
    ratio = 1 + two.edge / two.reach
    return models, f" scheme {scheme}", text + (
        matrix("wellDepth", two.depth)
        + f"fix r all property/global wellRatio peratomtype {ratio:.17g} {ratio:.17g}\n")


def run(program, law, scheme, two, dampings, spheres, finer=1, wall=False, times=(0.0,)):
    """State, messages, and for each of `times`, contact times after the end, rows of id, place, velocity.
    spheres: type, radius, density, place, velocity."""
    p, dt = two.values, two.dt / finer
    far = 2 * (two.duration * two.scale + 4 * RADIUS + abs(two.gap)) + 4 * two.seen
    skin = max(0.2 * RADIUS, 2.5 * two.seen, 30 * two.dt * two.scale)
    models, keywords, properties = contacts(law, scheme, two, dampings)
    text = "".join(f"create_atoms {kind} single {x[0]:.17g} {x[1]:.17g} {x[2]:.17g} units box\n"
                   f"set atom {n} diameter {2 * r:.17g} density {d:.17g} vx {v[0]:.17g} vy {v[1]:.17g} vz {v[2]:.17g}\n"
                   for n, (kind, r, d, x, v) in enumerate(spheres, 1))
    line = f"fix w all wall/gran {models} primitive type 2 xplane 0{keywords}\n" if wall else ""
    end = math.ceil(two.duration / two.dt)
    # A dump comes at all multiples of its step: the last of them is wanted, which is none of the other's.
    dumped = {f"at{n}": (end + math.ceil(time * p["steps"])) * finer for n, time in enumerate(times)}
    script = SCRIPT.format(box=" ".join(3 * [f"{-far:.17g} {far:.17g}"]), skin=skin, spheres=text, models=models + keywords,
                           wall=line, properties=properties, dt=dt, last=max(dumped.values()),
                           dumps="".join(DUMP.format(name=name, step=step) for name, step in dumped.items()))
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "in.script").write_text(script)
        try:
            ended = launcher.run(launcher.command(program, "in.script", log="none"), folder, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return "hangs", "", None
        if ended.code:
            error = re.search(r"^ERROR[^:]*: (.*)", ended.output, re.M)
            return ("refused", short(error[1]), None) if error else ("crashed", ended.output[-200:], None)
        rows = [dumps.read(Path(folder) / f"{name}.txt")[-1].table for name in dumped]
        return "ran", warnings(ended.output, contacts_of(spheres, wall)), rows


def contacts_of(spheres, wall):
    """Those that occur, by types, as the styles name them."""
    if wall:
        return ("1 - wall",)
    return ("1 - 2", "2 - 2") if len(spheres) == 3 else ("1 - 2",)


def verdict(said, right):
    return "right" if right else WRONG[fits(said)]


def judge_two(program, law, scheme, values, start, wall):
    p = {**ALL[law], **values}
    small = RADIUS / p["ratio"]
    density = DENSITY * p["weight"]
    mass = lambda r, d: 4 / 3 * math.pi * r**3 * d
    masses = [mass(small, density)] if wall else [mass(small, density), mass(RADIUS, DENSITY)]
    pair = partners(law, p, [small] if wall else [small, RADIUS], masses, start)
    share = [1.0] if wall else [masses[1] / sum(masses), -masses[0] / sum(masses)]
    spheres = [(1, small, density, (pair.reach + pair.gap if not wall else small + pair.gap, 0, 0),
                (-share[0] * p["speed"], 0, 0))]
    if not wall:
        spheres.append((2, RADIUS, DENSITY, (0, 0, 0), (-share[1] * p["speed"], 0, 0)))
    state, said, end = run(program, law, scheme, pair, (0.0, pair.gamman, 0.0), spheres, wall=wall)
    if state != "ran":
        return state, None, said
    end = end[0]
    gap = end[0, 1] - small if wall else abs(end[0, 1] - end[1, 1]) - pair.reach
    speed = end[0, 4] if wall else end[0, 4] - end[1, 4]
    if p["overlap"]:
        return verdict(said, abs(speed) / pair.scale - 1 < AIM), None, said
    if law in INTEGRATED:
        state, fine_said, fine = run(program, law, scheme, pair, (0.0, pair.gamman, 0.0), spheres, finer=FINER, wall=wall)
        if state != "ran":
            return f"reference {state}", None, fine_said
        if fits(fine_said, (ROUNDED,)) == "warned":
            return "no reference", None, said
        stuck = [(e[0, 1] - small if wall else abs(e[0, 1] - e[1, 1]) - pair.reach) < pair.edge for e in (end, fine[0])]
        # Of the two that stick, places on the time levels are those of a swing.
        error = 0.0 if all(stuck) else float(numpy.abs(end[:, 4:7] - fine[0][:, 4:7]).max() / pair.scale)
        return verdict(said, error < AIM), error, said
    known, now = pair.left_over(), 0.5 * pair.mu * speed**2 + pair.energy(gap)
    stuck = now < 0 or (known < 0 and gap < pair.edge)
    error = 0.0 if known < 0 and stuck else abs(
        math.sqrt(2 * max(now, 0) / pair.mu) - math.sqrt(2 * max(known, 0) / pair.mu)) / pair.scale
    # Whether they stick is judged within the tolerance, too: of a speed of zero.
    return verdict(said, error < AIM), error, said


def judge_three(program, law, scheme, values, start):
    p = {**ALL[law], **values}
    if p["overlap"]:
        return "not set up", None, ""
    small, density = RADIUS / p["ratio"], DENSITY * p["weight"]
    mass = lambda r, d: 4 / 3 * math.pi * r**3 * d
    one = partners(law, p, [small, RADIUS], [mass(small, density), mass(RADIUS, DENSITY)], start)
    equal = partners(law, p, [RADIUS, RADIUS], 2 * [mass(RADIUS, DENSITY)], start)
    deep = equal.deep if law in INTEGRATED else equal.force / p["K"]
    if deep > 0.5 * RADIUS:
        return "not set up", None, ""
    way = numpy.array([math.cos(0.5), math.sin(0.5), 0])
    spheres = [(2, RADIUS, DENSITY, (0, 0, 0), (0, 0, 0)), (2, RADIUS, DENSITY, (0, deep - 2 * RADIUS, 0), (0, 0, 0)),
               (1, small, density, (one.reach + one.gap) * numpy.array([1.0, 0, 0]), -p["speed"] * way)]
    dampings = (0.0, one.gamman, equal.gamman)
    state, said, ends = run(program, law, scheme, one, dampings, spheres, times=(0.0, LATER))
    if state != "ran":
        return state, None, said
    fine_state, fine_said, fines = run(program, law, scheme, one, dampings, spheres, finer=FINER,
                                       times=(0.0, LATER))
    if fine_state != "ran":
        return f"reference {fine_state}", None, fine_said
    if fits(fine_said, (ROUNDED,)) == "warned":
        return "no reference", None, said

    def sticking(rows):
        radii = (RADIUS, RADIUS, small)
        return [math.dist(rows[i, 1:4], rows[j, 1:4]) - radii[i] - radii[j] < one.edge
                for i, j in ((0, 1), (0, 2), (1, 2))]

    errors = [float(numpy.abs(end[:, 4:7] - fine[:, 4:7]).max() / one.scale) for end, fine in zip(ends, fines)]
    return of_times(said, errors, [sticking(end) == sticking(fine) and error < AIM
                                   for end, fine, error in zip(ends, fines, errors)])


def of_times(said, errors, right):
    """Verdict, error and warnings of a triple at two times; `right`: at each."""
    shown = errors[1] if tuple(right) == (False, True) else errors[0]
    return verdict(said, any(right)) + ONCE.get(tuple(right), ""), shown, said


def said_of(results):
    """Of pair, wall and three spheres, once where it is the same of all that ran; of contacts that do not occur only
    where nothing else was said."""
    texts = {case: said if found == WRONG["elsewhere"] else of_own(said)
             for case, (found, _, said) in zip(CASES, results) if found != "not set up"}
    if len(set(texts.values())) == 1:
        return next(iter(texts.values()))
    return ". ".join(f"{case}: {text}" for case, text in texts.items() if text)
