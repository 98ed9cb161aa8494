# SPDX-License-Identifier: BSD-3-Clause
"""Two spheres that meet, many couples in one box: what the tests of gran/hamaker share."""
import math
from pathlib import Path

import numpy
from scipy.integrate import solve_ivp

from cohesion_tests import lammps as engine
from cohesion_tests.theory.pair_motion import CONTACT_TIME, CUT, DENSITY, DIAMETER, MU, STIFFNESS


def leaves_at(pair, speed, angle):
    """Relative velocity (along x, along y) far away after a contact without friction; the couple
    meets in direction y as oblique() of gran_hamaker_couple_test makes it: 2e-6 m of straight flight
    before the edge of the adhesion, which is what an integration then follows from H_out on."""
    velocity = -speed * numpy.array([math.sin(angle), math.cos(angle)])
    place = numpy.array([0.0, DIAMETER + (pair.cut if pair.A else 0.0)]) - velocity / speed * 2e-6

    def motion(_, state):
        distance = math.hypot(state[0], state[1])
        gap = distance - DIAMETER
        normal = state[:2] / distance
        force = -pair.attraction(gap)
        if gap < 0.0:
            force -= STIFFNESS * gap + pair.damping * (normal @ state[2:])
        return numpy.concatenate([state[2:], force / MU * normal])

    # Steps of five cut-offs at most: not to miss the attraction.
    path = solve_ivp(motion, (0, 3 * CONTACT_TIME + 2e-6 / speed), [*place, *velocity],
                     method="DOP853", rtol=1e-9, atol=1e-14, max_step=5 * CUT / speed)
    return path.y[2:, -1]


def couple(number, gap, velocity, normal=(0.0, 1.0, 0.0), columns=25, pitch=(2.5e-3, 4e-3),
           types=(1, 1), diameters=(DIAMETER, DIAMETER), densities=(DENSITY, DENSITY),
           spins=((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))):
    """The number-th couple of a box: two atoms for lammps.py. The second is the first's normal
    plus gap away; `velocity` is the first's relative to the second, momentum zero."""
    masses = [density * diameter**3 for density, diameter in zip(densities, diameters)]
    share = masses[1] / sum(masses)
    first = numpy.array([1.5e-3 + pitch[0] * (number % columns),
                         1e-3 + pitch[1] * (number // columns), 1e-3])
    second = first + (0.5 * sum(diameters) + gap) * numpy.asarray(normal)
    velocity = numpy.asarray(velocity)
    return [{"type": types[k], "diameter": diameters[k], "density": densities[k], "x": x, "v": v,
             "omega": spins[k]}
            for k, (x, v) in enumerate(((first, share * velocity),
                                        (second, (share - 1) * velocity)))]


def run(atoms, coefficients, dt, steps, every=0, style="gran/hamaker", skin=1e-4, types=1,
        size=(0.064, 0.25, 0.004)):
    """Runs couples; gives snapshots (snapshot, couple, atom, column), without the id, and LAMMPS's
    output. `every`: steps between snapshots; 0 for the
    first and the last only, and no energy tally."""
    with engine.temporary_folder() as folder:
        engine.write_spheres(folder, atoms, [(0.0, length) for length in size], types)
        (Path(folder) / "coefficients.txt").write_text(
            "".join(f"pair_coeff {line}\n" for line in coefficients))
        output = engine.run("in.couples", folder, style=style, skin=skin, dt=dt, steps=steps,
                            every=every or steps, tally="yes" if every else "no")
        path = [table[:, 1:].reshape(-1, 2, table.shape[1] - 1)
                for table in engine.dumps(folder, "path.txt")]
    return numpy.array(path), output
