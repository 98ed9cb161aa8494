#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The cohesion models at the ends of their parameters, through LIGGGHTS: two spheres that meet head-on, a sphere and
a wall, and a sphere that strikes two that touch.

  extremes.py LIGGGHTS_COHESION [--table FILE] [--points N] [--seed N] [--jobs N]

hooke/stiffness without friction, six contact times (of the undamped spring) and the flight through a well, or into
contact: a cut-off that takes longer than a contact time to fly through is entered on the way. Pair and wall are
compared with the closed form: who sticks, and the energy that is left over, with which a speed is worked out. Three
spheres are compared with a run at a sixteenth of the step: who sticks, and all velocities; a run whose step is so small
that it warns of rounded places is no reference. Errors are relative to the largest speed that the point has: of impact,
from the attraction, F_ad/sqrt(mu K).

Verdicts: `right` below 0.1, what sampled forces are used for; `wrong, warned`: other, and the run said that the step
is too large for the contact, the cut-off or the well, or too small for rounded places; `wrong, silent`: it did not;
`refused`; `crashed` or `hangs`. Of an overlap at the start is asked that no energy is gained.
"""
import argparse
import collections
import concurrent.futures
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "lammps-package"))
from progress import Progress

RADIUS, DENSITY, PERIODS, AIM, FINER = 5e-4, 2650.0, 6, 0.1, 16
SECONDS = 30
BASE = dict(K=800.0, e=0.9, ratio=1.0, weight=1.0, speed=0.05, steps=20.0, overlap=0.0)
LAWS = {"hamaker": dict(BASE, cut=4e-10, A=7.5e-19), "square_well": dict(BASE, depth=0.5, width=0.3)}
UNITS = dict(K="N/m", cut="m", A="J", speed="m/s")
NAMES = dict(ratio="radius ratio", weight="density ratio", cut="H_cut", steps="t_c/dt", overlap="overlap/(r_i+r_j)")
COMMON = ([dict(K=k) for k in (10.0, 1e7)] + [dict(e=e) for e in (0.0, 1e-3, 0.5, 1.0)]
          + [dict(ratio=r) for r in (10.0, 100.0)] + [dict(weight=w) for w in (1e-6, 1e6)]
          + [dict(speed=s) for s in (1e-9, 1e-6, 1e-3, 1.0, 10.0, 100.0)] + [dict(speed=100.0, K=1e7)]
          + [dict(steps=s) for s in (1.5, 2.0, 4.0, 10.0, 15.0, 100.0, 1000.0, 10000.0)]
          + [dict(steps=s, e=0.0) for s in (1.5, 2.0, 4.0, 15.0)])
CORNERS = {
    "hamaker": COMMON + [dict(cut=c, A=a) for c in (1e-10, 1e-7) for a in (1e-21, 7.5e-19, 1e-16)]
    + [dict(A=a) for a in (0.0, 1e-21, 1e-17, 1e-16)] + [dict(cut=1e-7, A=1e-16, speed=1e-3, steps=1000.0)]
    + [dict(overlap=0.1, speed=0.0, A=a) for a in (0.0, 7.5e-19)],
    "square_well": COMMON + [dict(depth=d, width=w) for d in (0.0, 1e-3, 1e3) for w in (1e-3, 10.0)]}
FOUND = ("right", "wrong, warned", "refused", "not set up", "no reference")
# A spring that is too soft for its material is no reason for a wrong number.
ROUNDED = "raise the time step to"
WARNED = ("which pairs stick is left to chance", "the sampled scheme should have", "leaves its well by more than",
          ROUNDED)


def random_point(law, random):
    log = lambda low, high: float(10 ** random.uniform(math.log10(low), math.log10(high)))
    point = dict(K=log(10, 1e7), e=float(random.choice([0.0, 1.0, *random.uniform(0, 1, 8)])), ratio=log(1, 100),
                 weight=log(1e-3, 1e3), speed=log(1e-9, 100), steps=log(1, 1000), overlap=0.0)
    if law == "hamaker":
        return dict(point, cut=log(1e-10, 1e-7), A=float(random.choice([0.0, *[log(1e-21, 1e-16) for _ in range(7)]])))
    return dict(point, depth=log(1e-3, 1e3), width=log(1e-3, 10))


class Partners:
    """Two spheres, or a sphere and a wall, with their law: masses, energies, and what comes of an impact."""

    def __init__(self, law, values, radii, masses, start):
        p = self.values = values
        self.law = law
        self.reach = sum(radii)
        self.mu = 1 / sum(1 / m for m in masses)
        self.w0 = math.sqrt(p["K"] / self.mu)
        self.zeta = 1.0 if p["e"] == 0 else -math.log(p["e"]) / math.hypot(math.pi, math.log(p["e"]))
        self.gamman = 2 * self.zeta * self.w0
        self.dt = math.pi / self.w0 / p["steps"]
        if law == "hamaker":
            # A wall: one radius.
            self.reduced = radii[0] * radii[1] / self.reach if len(radii) == 2 else radii[0]
            self.out = 100 * p["cut"]
            self.force = p["A"] * self.reduced / (6 * p["cut"]**2)
            self.edge = p["cut"]
            self.seen = self.out
        else:
            added = p["depth"] * p["speed"]
            self.force, self.depth = 0.0, 0.5 * self.mu * added**2
            inside = math.hypot(p["speed"], added)
            self.edge = self.seen = min(p["width"] * inside / self.w0 * math.pi, 0.4 * self.reach)
        # From the edge, or from where the attraction brings them together in a contact time.
        near = p["speed"] * math.pi / self.w0 + self.force / self.mu * (math.pi / self.w0)**2 / 2
        begin = self.edge * (1 + 1e-9) if law == "square_well" else min(self.edge * (1 + 1e-9), near)
        self.gap = -p["overlap"] * self.reach if p["overlap"] else begin + start * self.dt * p["speed"]
        self.well = -self.energy(0.0)
        self.scale = max(p["speed"], math.sqrt(2 * self.well / self.mu), self.force / math.sqrt(self.mu * p["K"]),
                         self.w0 * p["overlap"] * self.reach, 1e-300)
        flight = math.pi / self.w0 if law == "hamaker" else 3 * self.edge / max(math.hypot(p["speed"], added), 1e-300)
        self.duration = PERIODS * math.pi / self.w0 + flight

    def energy(self, gap):
        if self.law == "square_well":
            return -self.depth if gap < self.edge else 0.0
        cut, p = self.values["cut"], self.values
        if gap >= self.out:
            return 0.0
        tail = p["A"] * self.reduced / 6 * (1 / max(gap, cut) - 1 / self.out)
        return -tail - self.force * max(cut - gap, 0.0)

    def left_over(self):
        """Energy of the motion far apart after the impact, below 0 when they stick; closed form."""
        from scipy.optimize import brentq
        u = math.sqrt(self.values["speed"]**2 + 2 * (self.energy(self.gap) + self.well) / self.mu)
        b = self.force / math.sqrt(self.mu * self.values["K"])
        zeta = self.zeta
        if self.values["e"] == 0:
            overlap = lambda t: b + math.exp(-t) * (-b + (u - b) * t)
            rate = lambda t: math.exp(-t) * (u - (u - b) * t)
            return -1.0 if b or u >= 0 else rate(overlap(0.0))
        q = math.sqrt(1 - zeta**2)
        if u == 0.0:
            return -1.0
        overlap = lambda t: b + math.exp(-zeta * t) * (-b * math.cos(q * t) + (u - zeta * b) / q * math.sin(q * t))
        rate = lambda t: math.exp(-zeta * t) * (u * math.cos(q * t) + (b - zeta * u) / q * math.sin(q * t))
        peak = brentq(rate, 1e-12, math.pi / q)
        end = peak + math.pi / q
        if overlap(end) > 0:
            return -1.0
        w = rate(brentq(overlap, peak, end, xtol=1e-15))
        return 0.5 * self.mu * w * w - self.well


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
pair_style gran model hooke/stiffness tangential off cohesion {law}
pair_coeff * *
{wall}fix move all nve/sphere
timestep {dt:.17g}
thermo 1000000
run {steps}
dump end all custom 1 end.txt id x y z vx vy vz
dump_modify end format "%d %.17g %.17g %.17g %.17g %.17g %.17g" sort id
run 0
"""


def matrix(name, *values):
    one, both, other = values if len(values) == 3 else 3 * values
    return (f"fix {name} all property/global {name} peratomtypepair 2 {one:.17g} {both:.17g} {both:.17g} "
            f"{other:.17g}\n")


def run(launcher, law, partners, dampings, spheres, finer=1, wall=False):
    """State, what was said, and rows of id, place, velocity. spheres: type, radius, density, place, velocity."""
    p, dt = partners.values, partners.dt / finer
    far = 2 * (partners.duration * partners.scale + 4 * RADIUS + abs(partners.gap)) + 4 * partners.seen
    skin = max(0.2 * RADIUS, 2.5 * partners.seen, 30 * partners.dt * partners.scale)
    properties = "".join(matrix(name, p["K"]) for name in ("kn", "kt")) + matrix("gamman", *dampings) + matrix(
        "gammat", 0.0)
    if law == "hamaker":
        properties += (matrix("hamakerConstant", p["A"])
                       + f"fix c all property/global hamakerSurfaceCutoff scalar {p['cut']:.17g}\n"
                       f"fix o all property/global hamakerOuterCutoff scalar {100 * p['cut']:.17g}\n")
    else:
        ratio = 1 + partners.edge / partners.reach
        properties += (matrix("wellDepth", partners.depth)
                       + f"fix r all property/global wellRatio peratomtype {ratio:.17g} {ratio:.17g}\n")
    text = "".join(f"create_atoms {kind} single {x[0]:.17g} {x[1]:.17g} {x[2]:.17g} units box\n"
                   f"set atom {n} diameter {2 * r:.17g} density {d:.17g} vx {v[0]:.17g} vy {v[1]:.17g} vz {v[2]:.17g}\n"
                   for n, (kind, r, d, x, v) in enumerate(spheres, 1))
    line = (f"fix w all wall/gran model hooke/stiffness tangential off cohesion {law} primitive type 2 xplane 0\n"
            if wall else "")
    script = SCRIPT.format(box=" ".join(3 * [f"{-far:.17g} {far:.17g}"]), skin=skin, spheres=text, law=law, wall=line,
                           properties=properties, dt=dt, steps=math.ceil(partners.duration / partners.dt) * finer)
    with tempfile.TemporaryDirectory() as folder:
        try:
            done = subprocess.run([launcher, "-in", "/dev/stdin", "-log", "none"], input=script, cwd=folder, text=True,
                                  errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=SECONDS,
                                  # Runs that start at once must not share Open MPI's folder.
                                  env={**os.environ, "OMP_NUM_THREADS": "1", "OMPI_MCA_orte_tmpdir_base": folder})
        except subprocess.TimeoutExpired:
            return "hangs", "", None
        said = " ".join(re.findall("WARNING: (.*)", done.stdout))
        if done.returncode:
            error = re.search(r"^ERROR[^:]*: ([^(]*)", done.stdout, re.M)
            return ("refused", error[1].strip(), None) if error else ("crashed", done.stdout[-200:], None)
        rows = (pathlib.Path(folder) / "end.txt").read_text().split("ITEM: ATOMS")[1].strip().split("\n")[1:]
        return "ran", said, numpy.array([[float(w) for w in row.split()] for row in rows])


def verdict(state, said, same, error):
    if state != "ran":
        return state
    if same and error < AIM:
        return "right"
    return "wrong, " + ("warned" if any(words in said for words in WARNED) else "silent")


def judge_two(launcher, law, values, start, wall):
    p = {**LAWS[law], **values}
    small = RADIUS / p["ratio"]
    density = DENSITY * p["weight"]
    mass = lambda r, d: 4 / 3 * math.pi * r**3 * d
    masses = [mass(small, density)] if wall else [mass(small, density), mass(RADIUS, DENSITY)]
    pair = Partners(law, p, [small] if wall else [small, RADIUS], masses, start)
    share = [1.0] if wall else [masses[1] / sum(masses), -masses[0] / sum(masses)]
    spheres = [(1, small, density, (pair.reach + pair.gap if not wall else small + pair.gap, 0, 0),
                (-share[0] * p["speed"], 0, 0))]
    if not wall:
        spheres.append((2, RADIUS, DENSITY, (0, 0, 0), (-share[1] * p["speed"], 0, 0)))
    state, said, end = run(launcher, law, pair, (0.0, pair.gamman, 0.0), spheres, wall=wall)
    if state != "ran":
        return state, None, said
    gap = end[0, 1] - small if wall else abs(end[0, 1] - end[1, 1]) - pair.reach
    speed = end[0, 4] if wall else end[0, 4] - end[1, 4]
    if p["overlap"]:
        return verdict(state, said, True, max(0.0, abs(speed) / pair.scale - 1)), None, said
    known, now = pair.left_over(), 0.5 * pair.mu * speed**2 + pair.energy(gap)
    stuck = now < 0 or (known < 0 and gap < pair.edge)
    error = 0.0 if known < 0 and stuck else abs(
        math.sqrt(2 * max(now, 0) / pair.mu) - math.sqrt(2 * max(known, 0) / pair.mu)) / pair.scale
    # Who sticks is asked within the aim, too: of a speed of nothing.
    return verdict(state, said, True, error), error, said


def judge_three(launcher, law, values, start):
    """At the end; where that is wrong, once more half a contact time later: a turn that comes late is no wrong
    velocity once both runs have it, other errors stay."""
    first = compare_three(launcher, law, values, start, 0.0)
    if not first[0].startswith("wrong"):
        return first
    second = compare_three(launcher, law, values, start, 0.5)
    return second if second[0] == "right" else first


def compare_three(launcher, law, values, start, later):
    p = {**LAWS[law], **values}
    if p["overlap"]:
        return "not set up", None, ""
    small, density = RADIUS / p["ratio"], DENSITY * p["weight"]
    mass = lambda r, d: 4 / 3 * math.pi * r**3 * d
    one = Partners(law, p, [small, RADIUS], [mass(small, density), mass(RADIUS, DENSITY)], start)
    equal = Partners(law, p, [RADIUS, RADIUS], 2 * [mass(RADIUS, DENSITY)], start)
    one.duration += later * math.pi / one.w0
    deep = equal.force / p["K"]
    if deep > 0.5 * RADIUS:
        return "not set up", None, ""
    way = numpy.array([math.cos(0.5), math.sin(0.5), 0])
    spheres = [(2, RADIUS, DENSITY, (0, 0, 0), (0, 0, 0)), (2, RADIUS, DENSITY, (0, deep - 2 * RADIUS, 0), (0, 0, 0)),
               (1, small, density, (one.reach + one.gap) * numpy.array([1.0, 0, 0]), -p["speed"] * way)]
    dampings = (0.0, one.gamman, equal.gamman)
    state, said, end = run(launcher, law, one, dampings, spheres)
    if state != "ran":
        return state, None, said
    fine_state, fine_said, fine = run(launcher, law, one, dampings, spheres, finer=FINER)
    if fine_state != "ran":
        return f"reference {fine_state}", None, fine_said
    if ROUNDED in fine_said:
        return "no reference", None, said

    def sticking(rows):
        radii = (RADIUS, RADIUS, small)
        return [math.dist(rows[i, 1:4], rows[j, 1:4]) - radii[i] - radii[j] < one.edge
                for i, j in ((0, 1), (0, 2), (1, 2))]

    error = float(numpy.abs(end[:, 4:7] - fine[:, 4:7]).max() / one.scale)
    return verdict(state, said, sticking(end) == sticking(fine), error), error, said


def name_of(values):
    return ", ".join(f"{NAMES.get(k, k)} {v:.4g}{' ' + UNITS[k] if k in UNITS else ''}" for k, v in values.items())


SHORT = (("a contact takes ([^ ]*) time steps", r"\1 steps per contact"),
         ("crosses the surface cut-off in ([^ ]*) time steps", r"\1 steps in the cut-off"),
         ("the largest overlap of an impact is ([^ ]*) %", r"impact overlap \1 %"),
         ("the overlap of a resting pair is ([^ ]*) %", r"resting overlap \1 %"),
         ("makes contacts (unstable)", r"\1"))


def brief(said):
    found = [m.expand(short) for pattern, short in SHORT for m in [re.search(pattern, said)] if m]
    return "; ".join(found) or ("" if "WARNING" not in said else said)


def cell(result):
    return f"{result[0]}" + ("" if result[1] is None else f", {result[1]:.1e}")


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher")
    words.add_argument("--table", metavar="FILE", help="where to write the page as well")
    words.add_argument("--points", type=int, default=100, help="random ones of each law")
    words.add_argument("--seed", type=int, default=4711)
    words.add_argument("--jobs", type=int, default=1, help="runs at a time")
    words = words.parse_args()
    random = numpy.random.default_rng(words.seed)
    points = [(law, values, corner) for law in LAWS
              for values, corner in [(c, True) for c in CORNERS[law]]
              + [(random_point(law, random), False) for _ in range(words.points)]]
    starts = [random.uniform(0.2, 1.2) for _ in points]

    def judge(point, start):
        law, values, _ = point
        results = [judge_two(words.launcher, law, values, start, wall) for wall in (False, True)]
        return results + [judge_three(words.launcher, law, values, start)]

    progress, rows = Progress(len(points)), []
    pool = concurrent.futures.ThreadPoolExecutor(words.jobs)
    for (law, values, corner), results in zip(points, pool.map(judge, points, starts)):
        rows.append((law, values, corner, results))
        progress.add(1)
    print(file=sys.stderr)
    text = report(rows)
    print(text)
    if words.table:
        pathlib.Path(words.table).write_text(text)


def report(rows):
    kinds = ("right", "wrong, warned", "wrong, silent", "refused", "crashed", "hangs")
    lines = ["# LIGGGHTS cohesion models at the ends of their parameters", "",
             "Written by `tests/liggghts-styles/extremes.py`, which says what was done and what the verdicts mean.",
             "hooke/stiffness, spheres of 1 mm and 2650 kg/m^3. depth: speed that the well adds, over the speed of impact;",
             "width: of the well, over the flight within it in a contact time.", "",
             "| model | case | points | " + " | ".join(kinds) + " | not set up, or no reference |",
             "|---|---|---|" + (len(kinds) + 1) * "---|"]
    for law in LAWS:
        for k, case in enumerate(("pair", "wall", "three spheres")):
            count = collections.Counter(r[k][0] for name, _, _, r in rows if name == law)
            lines.append(f"| {law} | {case} | {sum(count.values())} | " + " | ".join(str(count[v]) for v in kinds)
                         + f" | {sum(n for v, n in count.items() if v not in kinds)} |")
    for law in LAWS:
        lines += ["", f"## {law}", "", "Base point: " + name_of(LAWS[law]) + ". One parameter at a time:", "",
                  "| changed | pair | wall | three spheres | said of the pair |", "|---|---|---|---|---|"]
        lines += [f"| {name_of(v)} | " + " | ".join(map(cell, r)) + f" | {brief(r[0][2])} |"
                  for name, v, corner, r in rows if name == law and corner]
        silent = [(v, r) for name, v, corner, r in rows if name == law and not corner
                  and any(x[0] not in FOUND for x in r)]
        lines += ["", f"Random points neither right nor warned of nor refused: {len(silent)}"]
        if silent:
            lines += ["", "| point | pair | wall | three spheres | said of the pair |", "|---|---|---|---|---|"]
        lines += [f"| {name_of(v)} | " + " | ".join(map(cell, r)) + f" | {brief(r[0][2])} |" for v, r in silent]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
