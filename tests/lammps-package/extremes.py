#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""pair_style gran/hamaker at the ends of its parameters, through the engine: a pair that meets, and a
third sphere that strikes two that touch.

  extremes.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--table FILE] [--points N]

Every point is run at its step and at a sixteenth of it, for six contact times (of the undamped
spring). Compared: who sticks and all velocities at the end. Errors are relative to the larger of the
speed of impact, that which the attraction adds, sqrt(2 W/mu), F_ad/sqrt(mu K), and w0 times an overlap
at the start. A head-on pair is compared with the closed form as well: energy left over that at first
touch.

Verdicts: `right` below the aim, `other outcome`: who sticks differs, `wrong`, `refused`, `crashed`,
`hangs`. Aims: a pair without friction that has parted 1e-6; one in contact (w dt)^2/8, since the
velocity on the grid is the mean of those half a step before and after; with friction and for three
spheres second order, (w dt)^2, at most 0.1.
"""
import math
import re
import subprocess
import sys

import numpy

import measuring_program
from progress import Progress

DENSITY, RADIUS = 2650.0, 5e-4
REFERENCE = 16
PERIODS = 6
BASE = dict(K=800.0, e=0.9, ratio=1.0, weight=1.0, cut=4e-10, A=7.5e-19, speed=0.05, steps=10.0,
            mu=0.0, angle=30.0, overlap=0.0)
CORNERS = (
    [dict(K=k) for k in (10.0, 1e7)] + [dict(e=e) for e in (0.0, 1e-3, 0.5, 1.0)] +
    [dict(ratio=r) for r in (10.0, 100.0)] + [dict(weight=w) for w in (1e-6, 1e6)] +
    [dict(ratio=100.0, weight=1e6)] +
    [dict(cut=c, A=a) for c in (1e-10, 1e-7) for a in (1e-21, 7.5e-19, 1e-16)] +
    [dict(A=a) for a in (0.0, 1e-21, 1e-17, 1e-16)] +
    [dict(overlap=o, speed=0.0, A=a) for o in (1e-6, 0.1) for a in (0.0, 7.5e-19)] +
    [dict(overlap=0.1, speed=0.0, K=10.0), dict(overlap=0.1, speed=0.0, K=1e7)] +
    [dict(speed=s) for s in (0.0, 1e-9, 1e-6, 1e-3, 1.0, 10.0, 100.0)] +
    [dict(speed=100.0, K=1e7), dict(speed=1e-9, A=0.0), dict(speed=1e-9, A=1e-16)] +
    [dict(steps=s) for s in (1.9, 2.0, 3.0, 4.0, 20.0)] +
    [dict(steps=s, e=0.0) for s in (2.0, 4.0)] + [dict(steps=2.0, e=0.0, speed=1e-3)] +
    [dict(mu=m) for m in (0.3, 10.0)] + [dict(mu=0.3, angle=80.0), dict(mu=0.3, steps=4.0)] +
    [dict(angle=a) for a in (0.0, 60.0, 89.0, 89.99)] + [dict(angle=89.99, speed=1.0, e=1.0)])


def random_point(random):
    log = lambda low, high: float(10 ** random.uniform(math.log10(low), math.log10(high)))
    return dict(K=log(10, 1e7), e=float(random.choice([0.0, 1.0, *random.uniform(0, 1, 8)])),
                ratio=log(1, 100), weight=log(1e-3, 1e3), cut=log(1e-10, 1e-7),
                A=float(random.choice([0.0, *[log(1e-21, 1e-16) for _ in range(7)]])),
                speed=log(1e-9, 100), steps=log(2, 20), mu=float(random.choice([0, 0, 0.3, 1.0])),
                angle=float(random.choice([0, *random.uniform(0, 89, 4)])), overlap=0.0)


class Point:
    def __init__(self, random, **values):
        self.values = {**BASE, **values}
        p = self.values
        self.radius = (RADIUS, RADIUS / p["ratio"])
        # `weight`: how many times denser the smaller sphere is.
        self.density = (DENSITY, DENSITY * p["weight"])
        self.mass = [4 / 3 * math.pi * r**3 * d for r, d in zip(self.radius, self.density)]
        self.mu = self.mass[0] * self.mass[1] / sum(self.mass)
        self.w0 = math.sqrt(p["K"] / self.mu)
        self.contact = math.pi / self.w0
        self.reduced = RADIUS / (1 + p["ratio"])
        self.force = p["A"] * self.reduced / (6 * p["cut"]**2)
        self.well = (p["A"] * self.reduced / 6 * (1 - 0.01) / p["cut"]) + self.force * p["cut"]
        self.scale = max(p["speed"], math.sqrt(2 * self.well / self.mu),
                         self.force / math.sqrt(self.mu * p["K"]),
                         self.w0 * p["overlap"] * sum(self.radius), 1e-300)
        self.dt = self.contact / p["steps"]
        self.start = random.uniform(0.2, 1.2)

    def meet(self, centre, big, small):
        """Places and velocities of two spheres about to meet."""
        p = self.values
        sum_ = self.radius[big] + self.radius[small]
        angle = math.radians(p["angle"])
        way = numpy.array([math.cos(angle), math.sin(angle), 0.0])
        at_touch = sum_ * (1 - p["overlap"]) * numpy.array([1.0, 0.0, 0.0])
        gap = 0.0 if p["overlap"] else p["cut"] + self.start * self.dt * p["speed"]
        return centre, centre + at_touch + gap * way, -p["speed"] * way

    def write(self, engine, folder):
        p = self.values
        reach = PERIODS * self.contact * p["speed"] + 2e-2
        centre = numpy.zeros(3)
        first, second, velocity = self.meet(centre, 0, 1)
        spheres = [(0, first, 0 * velocity), (1, second, velocity)]
        # Two equal large spheres that touch, at rest; a small one comes.
        if not p["overlap"]:
            deep = self.force_of_equals() / p["K"]
            if deep < 0.5 * RADIUS:
                centre = numpy.array([0.0, 0.0, 8e-3])
                first, second, velocity = self.meet(centre, 0, 1)
                aside = numpy.array([0.0, 2 * RADIUS - deep, 0.0])
                spheres += [(0, centre, 0 * velocity), (0, centre - aside, 0 * velocity),
                            (1, second, velocity)]
        self.count = len(spheres)
        engine.write_spheres(folder, [{"type": 1 + kind, "diameter": 2 * self.radius[kind],
                                       "density": self.density[kind], "x": x, "v": v}
                                      for kind, x, v in spheres], 3 * [(-reach, reach)], 2)

    def force_of_equals(self):
        return self.values["A"] * RADIUS / 2 / (6 * self.values["cut"]**2)

    def run(self, engine, folder, finer):
        p = self.values
        steps = max(4, math.ceil(PERIODS * p["steps"]))
        skin = max(0.2 * RADIUS, 30 * self.dt * self.scale)
        command = [engine.LMP, "-in", str(engine.SCRIPTS / "in.gran_hamaker_extremes"), "-log", "none"]
        for name, value in dict(plugin=engine.PLUGIN, dt=self.dt / finer, steps=steps * finer,
                                K=p["K"], e=p["e"], mu=p["mu"], A=p["A"], cut=p["cut"],
                                skin=skin).items():
            command += ["-var", name, f"{value:.17g}" if isinstance(value, float) else str(value)]
        try:
            done = subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, timeout=30)
        except subprocess.TimeoutExpired:
            return "hangs", "", None
        warnings = sorted({brief(w) for w in re.findall(r"WARNING: (.*)", done.stdout)})
        if done.returncode != 0:
            error = re.search(r"ERROR.*?: (.*)", done.stdout)
            if error:
                return "refused", brief(error[1]), None
            return "crashed", done.stdout[-200:], None
        end = engine.dump(folder, "end.txt")
        energy = engine.thermo(done.stdout.split("Loop time")[0])
        return "ran", "; ".join(warnings), (end, energy["c_energy[10]"])

    def sticking(self, end):
        """Gaps below the cut-off, velocities."""
        kinds = [0, 1, 0, 0, 1][:self.count]
        stick = []
        for i, j in ((0, 1), (2, 3), (2, 4), (3, 4)):
            if j < self.count:
                gap = numpy.linalg.norm(end[i, 1:4] - end[j, 1:4]) \
                    - self.radius[kinds[i]] - self.radius[kinds[j]]
                stick.append(gap < self.values["cut"])
        return stick

    def head_on(self):
        """Energy left of that at first touch once parted, below 0 when captured; speed there."""
        from scipy.optimize import brentq
        p = self.values
        u = math.sqrt(p["speed"]**2 + 2 * self.well / self.mu)
        zeta = 1.0 if p["e"] == 0 else -math.log(p["e"]) / math.hypot(math.pi, math.log(p["e"]))
        b = self.force / math.sqrt(self.mu * p["K"])
        if zeta >= 1.0:
            overlap = lambda t: b + math.exp(-t) * (-b + (u - b) * t)
            rate = lambda t: math.exp(-t) * (u - (u - b) * t)
            q = 1e-2
        else:
            q = math.sqrt(1 - zeta**2)
            overlap = lambda t: b + math.exp(-zeta * t) * (
                -b * math.cos(q * t) + (u - zeta * b) / q * math.sin(q * t))
            rate = lambda t: math.exp(-zeta * t) * (
                u * math.cos(q * t) + (b - zeta * u) / q * math.sin(q * t))
        peak = brentq(rate, 1e-9, math.pi / q) if rate(math.pi / q) < 0 else math.inf
        end = peak + math.pi / q
        if not math.isfinite(end) or overlap(end) > 0:
            return None
        w = rate(brentq(overlap, peak, end, xtol=1e-15))
        return (w * w - 2 * self.well / self.mu) / u**2, u


BRIEF = (("in the spring adhesion does", "spring too soft for the adhesion"),
         ("the overlap of a resting pair is ([^ ]*) %", "resting overlap \\1 %"),
         ("the largest overlap of an impact is ([^ ]*) %", "impact overlap \\1 %"),
         ("a contact takes ([^ ]*) time steps", "\\1 steps per contact"))


def brief(message):
    for long, short in BRIEF:
        found = re.search(long, message)
        if found:
            return found.expand(short)
    return re.sub(r"pair_style gran/hamaker(, \d - \d)?: ", "", re.sub(r" \(\S+:\d+\)", "", message))


def judge(point, engine):
    """Dict of verdicts for `pair` and `three`, remarks and numbers."""
    with engine.temporary_folder() as folder:
        point.write(engine, folder)
        state, remark, coarse = point.run(engine, folder, 1)
        if state != "ran":
            return dict(pair=state, three=state, remark=remark, error={}, exact=None)
        fine_state, fine_remark, fine = point.run(engine, folder, REFERENCE)
        if fine_state != "ran":
            return dict(pair="no reference", three="no reference", remark=fine_remark, error={},
                        exact=None)
    sticks = [point.sticking(run[0]) for run in (coarse, fine)]
    difference = numpy.abs(coarse[0][:, 4:7] - fine[0][:, 4:7]).max(axis=1) / point.scale
    result = dict(remark=remark, error={}, exact=None)
    for name, spheres, links in (("pair", slice(0, 2), slice(0, 1)),
                                 ("three", slice(2, 5), slice(1, 4))):
        if name == "three" and point.count < 5:
            result[name] = "not set up"
            continue
        error = float(difference[spheres].max())
        result["error"][name] = error
        angle = math.pi / point.values["steps"]
        aim = min(angle**2, 0.1)
        if name == "pair" and not point.values["mu"]:
            aim = angle**2 / 8 if sticks[0][0] else 1e-6
        if not math.isfinite(error):
            result[name] = "wrong: not a number"
        elif sticks[0][links] != sticks[1][links]:
            result[name] = "other outcome"
        else:
            result[name] = "right" if error < aim else f"wrong by {error:.1g}"
    p = point.values
    if p["angle"] == 0.0 and p["mu"] == 0.0 and not p["overlap"] and p["speed"] > 0:
        known = point.head_on()
        relative = numpy.linalg.norm(coarse[0][1, 4:7] - coarse[0][0, 4:7])
        stuck = sticks[0][0]
        if known is None or known[0] < 0:
            result["exact"] = 0.0 if stuck else 1.0
        elif p["cut"] < p["speed"] * point.contact:  # else it is still in the gap
            result["exact"] = abs(relative**2 / known[1]**2 - known[0])
    return result


def name_of(values):
    units = dict(K="N/m", cut="m", A="J", speed="m/s", angle="deg")
    names = dict(ratio="radius ratio", weight="density ratio", cut="H_cut", steps="t_c/dt",
                 mu="friction", overlap="overlap/(r_i+r_j)")
    return ", ".join(f"{names.get(k, k)} {v:.4g}{' ' + units[k] if k in units else ''}"
                     for k, v in values.items())


def main():
    words = measuring_program.words(
        __doc__, ("--table", {"metavar": "FILE", "help": "where to write the page as well"}),
        ("--points", {"type": int, "default": 200, "help": "random ones"}))
    import lammps_engine as engine
    random = numpy.random.default_rng(4711)
    points = [(c, True) for c in CORNERS] + [(random_point(random), False) for _ in range(words.points)]
    progress, rows = Progress(len(points)), []
    for values, corner in points:
        rows.append((values, corner, judge(Point(random, **values), engine)))
        progress.add(1)
    print(file=sys.stderr)
    text = report(rows)
    print(text)
    if words.table:
        with open(words.table, "w") as file:
            file.write(text)


def numbers(result, name):
    return f"{result['error'][name]:.1e}" if name in result["error"] else ""


def report(rows):
    lines = ["# gran/hamaker at the ends of its parameters", "",
             "Written by `tests/lammps-package/extremes.py`, which says what was done and what the",
             "verdicts mean. Base point: " + name_of(BASE) + "; spheres of 1 mm, 2650 kg/m^3.", "",
             "## One parameter at a time", "",
             "| changed | pair | error | head-on: energy | three spheres | error | said |",
             "|---|---|---|---|---|---|---|"]
    for values, corner, r in rows:
        if corner:
            exact = "" if r["exact"] is None else f"{r['exact']:.1e}"
            lines.append(f"| {name_of(values)} | {r['pair']} | {numbers(r, 'pair')} | {exact} | "
                         f"{r['three']} | {numbers(r, 'three')} | {r['remark']} |")
    inner = [(v, r) for v, corner, r in rows if not corner]
    lines += ["", f"## {len(inner)} random points", "",
              "| t_c/dt | points | refused | crashed or hangs | pair: right | pair: other outcome | "
              "pair: wrong | three: right | three: other outcome | three: wrong |",
              "|---|---|---|---|---|---|---|---|---|---|"]
    for low, high in ((2, 3), (3, 4), (4, 5), (5, 10), (10, 20)):
        part = [r for v, r in inner if low <= v["steps"] < high]
        count = lambda name, *words: sum(r[name].startswith(words) for r in part)
        lines.append(f"| {low} to {high} | {len(part)} | {count('pair', 'refused')} | "
                     f"{count('pair', 'crashed', 'hangs', 'no reference')} | "
                     + " | ".join(f"{count(name, 'right')} | {count(name, 'other')} | "
                                  f"{count(name, 'wrong')}" for name in ("pair", "three")) + " |")
    lines += ["", "Head-on pairs among them, energy against the closed form: largest error "
              + f"{max([r['exact'] for _, r in inner if r['exact'] is not None], default=0):.1e}.",
              "", "What was not right:", "", "| point | pair | error | three | error | said |",
              "|---|---|---|---|---|---|"]
    for v, r in inner:
        good = ("right", "not set up", "refused")
        if r["pair"] not in good or r["three"] not in good:
            lines.append(f"| {name_of(v)} | {r['pair']} | {numbers(r, 'pair')} | {r['three']} | "
                         f"{numbers(r, 'three')} | {r['remark']} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    main()
