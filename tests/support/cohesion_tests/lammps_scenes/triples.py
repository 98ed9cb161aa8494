# SPDX-License-Identifier: BSD-3-Clause
"""Two spheres that stick, at rest, and a third that strikes them: 100 such triples, from 0.003 to
0.1 m/s. Also where adhesion decides: F_ad/sqrt(mu K) = 0.022 m/s. Or with one of hertzian_laws, of which the contact time
is that of an impact at 0.1 m/s.

Or 100 rows: two that touch at rest, and a third that strikes them head-on with 0.03 or 0.1 m/s, at 50 places in the step.
They last ten contact times."""
import math
import os

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import cohesive_gas as gas, settling_spheres as settling
from cohesion_tests.theory import hertzian_laws

D, T_C = gas.DIAMETER, gas.CONTACT_TIME
A, RESTITUTION, DURATION = 2e-18, 0.9487, 30 * T_C
ADHESION = A * D / (24 * settling.CUT**2)  # [N]
SPEEDS = numpy.repeat([0.003, 0.01, 0.03, 0.1], 25)
ROW_SPEEDS = numpy.repeat([0.03, 0.1], 50)


def contact_time(law):
    return T_C if law == "linear" else hertzian_laws.contact_time(law, SPEEDS[-1])


def distance(law):
    """Of the centres of two at rest."""
    return D - (ADHESION / gas.STIFFNESS if law == "linear" else hertzian_laws.overlap(law))


def write_rows(folder, law, steps_per_contact):
    """data.spheres; two speeds, 50 places in the step."""
    along, reach, time, spheres = distance(law), 2 * hertzian_laws.touching_gap(law), contact_time(law), []
    for n, speed in enumerate(ROW_SPEEDS):
        centre = 4e-3 * numpy.array([n % 10 + 0.5, n // 10 + 0.5, 0.5])
        ahead = reach + speed * time * (0.5 + n % 50 / 50 / steps_per_contact)
        for place, velocity in ((0, 0), (along, 0), (-D - ahead, speed)):
            spheres.append({"type": 1, "diameter": D, "density": gas.DENSITY, "x": centre + [place, 0, 0],
                            "v": numpy.array([velocity, 0, 0])})
    engine.write_spheres(folder, spheres, [(0, 0.04), (0, 0.04), (0, 4e-3)], 1)


def write(folder, law="linear"):
    """data.spheres; each triple in a cell of its own."""
    random = numpy.random.default_rng(1)
    half, time = 0.5 * distance(law), contact_time(law)
    spheres = []
    for n, speed in enumerate(SPEEDS):
        angle = math.radians((10, 50, 90, 130, 170)[n % 5])
        offset = (-0.9, -0.45, 0.02, 0.45, 0.9)[n // 5 % 5] * D
        centre = 4e-3 * numpy.array([n % 10 + 0.5, n // 10 + 0.5, 0.5])
        pair = [centre - [half, 0, 0], centre + [half, 0, 0]]
        around = random.uniform(0, 2 * math.pi)
        way = numpy.array([math.cos(angle), math.sin(angle) * math.cos(around),
                           math.sin(angle) * math.sin(around)])
        aside = numpy.cross(way, [0.3, 0.5, 0.8])
        start = pair[0] + offset * aside / numpy.linalg.norm(aside)
        meets = []
        for sphere in pair:
            to = start - sphere
            root = (to @ way)**2 - to @ to + D * D
            if root > 0:
                meets.append(-(to @ way) - math.sqrt(root))
        # One to two contact times before the first touch.
        start = start + (min(meets) - speed * random.uniform(1, 2) * time) * way
        for place, velocity in ((pair[0], 0 * way), (pair[1], 0 * way), (start, speed * way)):
            spheres.append({"type": 1, "diameter": D, "density": gas.DENSITY, "x": place,
                            "v": velocity})
    engine.write_spheres(folder, spheres, [(0, 0.04), (0, 0.04), (0, 4e-3)], 1)


def follow_without_friction(folder, division, duration, law, restitution, **scheme):
    """By in.head_on: sampled forces, or in LIGGGHTS the scheme that is named."""
    dt = contact_time(law) / division
    if law != "linear":
        cohesion = "jkr" if law == "jkr" else "hamaker"
        scheme = {"scheme": "exact", "models": f"hertz tangential off cohesion {cohesion}", "E": hertzian_laws.MODULUS,
                  "nu": hertzian_laws.POISSON, "e": restitution, "surface": hertzian_laws.SURFACE_ENERGY}
    constant = hertzian_laws.pair(law).hamaker if law in ("hertz", "dmt") else A
    log = math.log(restitution)
    engine.run("in.head_on", folder, **scheme, dt=dt, steps=round(duration / dt), K=gas.STIFFNESS,
               gamma=-2 * log / math.hypot(math.pi, log) * math.sqrt(2 * gas.STIFFNESS / gas.MASS),
               A=constant, cut=settling.CUT, out=1e-7)


def outcome(folder, division, friction, scheme="exact", law="linear", restitution=RESTITUTION, contact_times=30):
    """At t_c/division, after 30 t_c, followed by `scheme`, the sampled one and LIGGGHTS without friction: velocities
    (triple, sphere, axis), which of the three pairs stick (pair, triple), and the slowest speed at which two
    have parted (triple)."""
    time = contact_time(law)
    if not os.environ.get("COHESION_PLUGIN"):
        follow_without_friction(folder, division, contact_times * time, law, restitution, scheme=scheme)
    elif scheme == "sampled":
        follow_without_friction(folder, division, contact_times * time, law, restitution)
    else:
        gas.follow(folder, division, contact_times * time, 2, A=A, e=restitution, mu=friction,
                   skin=4e-4 if division < 4 else 2e-4, law=law, time=time)
    end = engine.dump(folder, "end.txt").reshape(len(SPEEDS), 3, -1)
    places, velocities = end[:, :, 1:4], end[:, :, 4:7]
    gaps, speeds = [], []
    for i, j in ((0, 1), (0, 2), (1, 2)):
        gaps.append(numpy.linalg.norm(places[:, i] - places[:, j], axis=1) - D)
        speeds.append(numpy.linalg.norm(velocities[:, i] - velocities[:, j], axis=1))
    stuck = numpy.array(gaps) < (settling.CUT if law == "linear" else hertzian_laws.touching_gap(law))
    return velocities, stuck, numpy.where(stuck, numpy.inf, numpy.array(speeds)).min(axis=0)
