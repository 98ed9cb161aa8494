# SPDX-License-Identifier: BSD-3-Clause
"""A gas of elastic spheres in a periodic box, in LIGGGHTS, and its energy."""
import math
import random
import re

import numpy
from scipy.spatial import cKDTree

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes import impacts
from cohesion_tests.liggghts_scenes.scene import (MASS, RADIUS, STIFFNESS, contact, hamaker, script, sphere,
                                                  surface_energy)
from cohesion_tests.theory import hertz_contact, hertzian_laws
from cohesion_tests.theory.pair_motion import CUT, OUT

DIAMETER = 2 * RADIUS
CONTACT_TIME = math.pi * math.sqrt(0.5 * MASS / STIFFNESS)  # of two elastic spheres, [s]


def elastic(restitution=1.0):
    """Contacts of this restitution between two spheres: with no dashpot along the normal."""
    text = contact()
    line = next(line for line in text.splitlines() if " gamman_abs " in line)
    return text.replace(line, matrix("gamman_abs", damping(restitution)))


def matrix(name, value):
    return f"fix {name} all property/global {name} peratomtypepair 2{f' {value!r}' * 4}"


def damping(restitution):
    """Of the dashpot that two spheres of this restitution have, [kg/s]."""
    part = -math.log(restitution)
    return 2 * part / math.hypot(math.pi, part) * math.sqrt(STIFFNESS * MASS / 2)


def gas(edge, fraction, seed=1, speed=0.1):
    """edge^3 spheres that fly at `speed` [m/s] (each component), and the side of their periodic box."""
    numbers = random.Random(seed)
    cell = DIAMETER * (numpy.pi / 6 / fraction)**(1 / 3)
    room = 0.4 * (cell - DIAMETER)
    sites = [(i, j, k) for i in range(edge) for j in range(edge) for k in range(edge)]
    speeds = [[numbers.gauss(0, speed) for _ in range(3)] for _ in sites]
    mean = [sum(v[d] for v in speeds) / len(speeds) for d in range(3)]
    return [sphere([cell * (n + 0.5) + numbers.uniform(-room, room) for n in site],
                   [v - m for v, m in zip(velocity, mean)])
            for site, velocity in zip(sites, speeds)], cell * edge


def kinetic_energy(frame):
    """Of a dumped frame: {id: row}, velocities in columns 3 to 5."""
    rows = numpy.array(list(frame.values()))
    return 0.5 * MASS * (rows[:, 3:6]**2).sum()


def gaps(frame, side, reach=0.0):
    """Between the surfaces of all pairs that are not further apart than `reach`; overlaps are < 0."""
    places = numpy.array(list(frame.values()))[:, :3] % side
    pairs = cKDTree(places, boxsize=side).query_pairs(DIAMETER + reach, output_type="ndarray")
    apart = places[pairs[:, 0]] - places[pairs[:, 1]]
    return numpy.linalg.norm(apart - side * numpy.round(apart / side), axis=1) - DIAMETER


def spring_energy(overlaps):
    return 0.5 * STIFFNESS * (numpy.minimum(overlaps, 0)**2).sum()


def energy(frame, side, pair):
    """Of a dumped frame, pair: theory.pair_motion.Pair. The tail counts at H_cut, where scheme exact crosses it."""
    near = gaps(frame, side, pair.cut)
    attraction = numpy.where(near < 0, pair.adhesion_energy(0.0) + pair.adhesion * near, 0.0)
    between = near[(near >= 0) & (pair.A > 0)]
    return kinetic_energy(frame) + spring_energy(near) + attraction.sum() + sum(map(pair.adhesion_energy, between))


def frictional(restitution, friction):
    """As elastic(), with friction: K_t = 2/7 K and half of the normal damping, as in lammps_scenes.cohesive_gas."""
    values = {"kt": 2 / 7 * STIFFNESS, "gammat_abs": 0.5 * damping(restitution), "coefficientFriction": friction}
    text = elastic(restitution)
    for name, value in values.items():
        text = re.sub(rf"^fix {name} .*$", matrix(name, value), text, flags=re.MULTILINE)
    return text


TALLY = "compute tally all gran/energy\n"
PRINT = ("thermo_style custom step c_tally " + " ".join(f"c_tally[{k}]" for k in range(1, 14))
         + "\nthermo {every}\nthermo_modify norm no " + " ".join(f"format {k} %.17g" for k in range(2, 16)) + "\n")


def tally_lines(run):
    """Step, scalar and entries of compute gran/energy, of each line of PRINT, of all runs."""
    lines = (line.split() for line in run.files["log.liggghts"].split("\n"))
    return [[float(word) for word in words] for words in lines if len(words) == 15 and words[0].isdigit()]


def hertzian(law, restitution, friction):
    """Models, properties of the cohesion and contacts of one of hertzian_laws, as in lammps_scenes.cohesive_gas."""
    models = (f"model hertz tangential {'history' if friction else 'off'} cohesion {'jkr' if law == 'jkr' else 'hamaker'} "
              f"tangential_damping {'on' if friction else 'off'}{'' if law == 'jkr' else ' scheme exact'}")
    attraction = surface_energy(hertzian_laws.SURFACE_ENERGY) if law == "jkr" else hamaker(
        hertzian_laws.HAMAKER if law == "dmt" else 0.0, cut=hertz_contact.CUT, out=hertz_contact.OUT)
    contacts = impacts.contacts(restitution, friction).replace("peratomtype 5e6 5e6", "peratomtype {0:g} {0:g}".format(
        hertzian_laws.MODULUS))
    return models, attraction, contacts


def tallied_gas(edge, fraction, constant, speed, restitution, friction, dt, duration, scheme="exact", law="linear",
                samples=1):
    """Lines of the energy tally of gas() in `duration` [s]: that of the start and `samples`; none where the step is not
    stable."""
    spheres, side = gas(edge, fraction, speed=speed)
    every = max(1, round(duration / dt / samples))
    steps = every * samples
    models = (f"model hooke/stiffness tangential {'history' if friction else 'off'} cohesion hamaker "
              f"absolute_damping on tangential_damping {'on' if friction else 'off'} scheme {scheme}")
    attraction, contacts = hamaker(constant, cut=CUT, out=OUT), frictional(restitution, friction)
    if law != "linear":
        models, attraction, contacts = hertzian(law, restitution, friction)
    run = Run(script(spheres, models, attraction, dt=dt, steps=steps, every=steps,
                     contacts=contacts, boundary="p p p", box=f"0 {side} 0 {side} 0 {side}",
                     skin=2e-4, extra=TALLY + PRINT.format(every=every)))
    if run.code and "unstable, so that they gain energy" in run.output:
        return []
    if run.code:
        raise AssertionError(run.output[-3000:])
    return tally_lines(run)
