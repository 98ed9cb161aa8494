# SPDX-License-Identifier: BSD-3-Clause
"""A gas of equal elastic spheres in a periodic box, for what is measured on many particles."""
import math

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.theory import hertzian_laws
from cohesion_tests.thermo import processor_seconds, thermo_lines

DIAMETER, DENSITY, STIFFNESS = 1e-3, 2650.0, 800.0
MASS = math.pi / 6 * DENSITY * DIAMETER**3
CONTACT_TIME = math.pi * math.sqrt(MASS / 2 / STIFFNESS)  # t_c without damping, [s]
FINEST = 80  # steps per contact that others are held against


def edge(count, fraction):
    """Of the box that holds `count` spheres at solid fraction `fraction`, [m]."""
    return (count * math.pi / 6 / fraction) ** (1 / 3) * DIAMETER


def collision_rate(fraction, speed):
    """Enskog's rate per particle with the contact value of Carnahan and Starling, [1/s]; `speed`
    [m/s] is the standard deviation of each component."""
    number = fraction / (math.pi / 6 * DIAMETER**3)
    near = (1 - fraction / 2) / (1 - fraction) ** 3
    return 4 * DIAMETER**2 * number * near * math.sqrt(math.pi) * speed


def write(folder, side, fraction, speed, seed):
    """side^3 spheres on a simple cubic lattice, whose first collisions break it up, with random
    velocities, no momentum and `speed` exactly."""
    random = numpy.random.default_rng(seed)
    length = edge(side**3, fraction)
    grid = (0.5 + numpy.arange(side)) * length / side
    places = numpy.array(numpy.meshgrid(grid, grid, grid)).reshape(3, -1).T
    velocities = random.normal(size=places.shape)
    velocities -= velocities.mean(axis=0)
    velocities *= speed / math.sqrt((velocities**2).mean())
    engine.write_spheres(folder, [{"type": 1, "diameter": DIAMETER, "density": DENSITY, "x": x,
                                   "v": v} for x, v in zip(places, velocities)],
                         3 * [(0.0, length)], 1)


def table(output):
    """Thermo lines of the first run, and the processor seconds it took."""
    return numpy.array(thermo_lines(output, 0)[1]), processor_seconds(output, 0)


def contact_time(law, speed):
    """Of the mean impact in a gas with component speed `speed`, [s]."""
    return CONTACT_TIME if law == "linear" else hertzian_laws.contact_time(law, hertzian_laws.mean_impact(speed))


def law_words(law):
    """Variables of the scripts, for laws that are not linear."""
    if law == "linear":
        return {}
    style, normal = hertzian_laws.lammps(law)
    return {"law": law, "style": style, "normal": normal}


def follow(folder, steps_per_contact, duration, samples=50, ranks=1, law="linear", time=CONTACT_TIME, **options):
    """Runs data.spheres for `duration` [s] at t_c/steps_per_contact; table and seconds. time: t_c, where law is one of
    hertzian_laws."""
    dt = time / steps_per_contact
    every = max(1, round(duration / dt / samples))
    values = {"scheme": "exact", "K": STIFFNESS, "e": 1.0, "mu": 0.0, "dratio": 0.5, "A": 0.0,
              "cut": 4e-10, "out": 1e-7, "skin": 0.2 * DIAMETER, "D": DIAMETER, "file": "end.txt",
              **law_words(law), **options}
    return table(engine.run("in.gran_hamaker_gas", folder, ranks=ranks, dt=dt,
                            steps=every * samples, every=every, **values))


def kept(folder, steps_per_contact, fraction, speed, **options):
    """Runs data.spheres, written with `fraction` and `speed`; its total energy after 14 collisions at Enskog's rate of
    the start over its kinetic energy at the start, of a parabola through samples about then. The kinetic energy of the
    time level alone depends on the step: that of a contact is smaller by (w0 dt)^2/8."""
    duration = 20 / collision_rate(fraction, speed)
    table, _ = follow(folder, steps_per_contact, duration, **options)
    time = table[:, 0] * options.get("time", CONTACT_TIME) / steps_per_contact / duration
    about = (time > 0.5) & (time < 0.9)
    return numpy.polyval(numpy.polyfit(time[about], table[about, 1], 2), 0.7) / table[0, 3]
