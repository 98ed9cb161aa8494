# SPDX-License-Identifier: BSD-3-Clause
"""Spheres that meet another, or a wall, at speeds around their escape velocity, at eight phases of the step: which of them
part. Elastic impacts that stick: what energy is left."""
import math

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl
from cohesion_tests.liggghts_scenes.scene import RADIUS, contact, script, sphere

PHASES = 8
DIAMETER = 2 * RADIUS
PLACE = -8.5e-3  # of the wall, and of the first spheres [m]
# A wall: words behind its models, lines before it, files.
PLANE = (f"primitive type 1 xplane {PLACE}", [], {})


def mesh(cells):
    """A square plate of 2 cells^2 triangles."""
    plate = rectangle((PLACE, -9.5e-3, -9.5e-3), (0, 1.9e-2, 0), (0, 0, 1.9e-2), cells)
    return ("mesh n_meshes 1 meshes square", [f"fix square all mesh/surface file square{cells}.stl type 1"],
            {f"square{cells}.stl": stl(plate)})


WALLS = {"pair": None, "plane": PLANE, "2 triangles": mesh(1), "200 triangles": mesh(10)}


def contacts(restitution, friction=0.3):
    """E 5e6 Pa, nu 0.3."""
    text = contact()
    for name, before, now in (("Restitution", 0.9, restitution), ("Friction", 0.3, friction)):
        old = f"fix coefficient{name} all property/global coefficient{name} peratomtypepair 2" + 4 * f" {before}"
        assert old in text
        text = text.replace(old, old.replace(str(before), str(float(now))))
    return text


def limits(models, keywords, properties, restitution, speed, degrees, grade, dt, steps, reference_gap, flight, free_gap,
           wall=None):
    """The slowest factor of the escape velocity at which one parted and the fastest at which one was captured, of 0.99,
    1 - grade, 1 + grade and 1.01.

    models, keywords: of pair_style gran and fix wall/gran; speed: escape velocity along the normal [m/s] of two whose
    surfaces are reference_gap [m] apart; flight: way up to there at the start [m]; free_gap: gap of those that parted;
    wall: one of WALLS."""
    factors, spheres = (0.99, 1 - grade, 1 + grade, 1.01), []
    for n, (factor, phase) in enumerate((f, p) for f in factors for p in range(PHASES)):
        inwards = factor * speed
        across = inwards * math.tan(math.radians(degrees))
        time = flight / inwards + dt * (phase + 0.5) / PHASES
        gap = reference_gap + inwards * time
        y, z = -8e-3 + 2e-3 * (n % PHASES), -8e-3 + 2e-3 * (n // PHASES)
        if wall:
            spheres.append(sphere((PLACE + RADIUS + gap, y, z), (-inwards, across, 0)))
        else:
            spheres += [sphere((PLACE, y, z), (inwards / 2, -across / 2, 0)),
                        sphere((PLACE + DIAMETER + gap, y - across * time, z), (-inwards / 2, across / 2, 0))]
    shape, before, inputs = wall or ("", [], {})
    walls = [*before, f"fix plate all wall/gran {models} {shape} {keywords}"] if wall else []
    text = script(spheres, f"{models} {keywords}", properties, dt=dt, steps=steps, every=steps, skin=2e-4,
                  contacts=contacts(restitution), walls=walls, box="-0.01 0.01 -0.01 0.06 -0.01 0.01")
    end = Run(text, inputs=inputs).frames("out.txt")[-1]
    if wall:
        gaps = [end[n][0] - PLACE - RADIUS for n in range(1, len(spheres) + 1)]
    else:
        gaps = [math.dist(end[n][:3], end[n + 1][:3]) - DIAMETER for n in range(1, len(spheres), 2)]
    parted = [gap > free_gap for gap in gaps]
    answers = {f: parted[k * PHASES:(k + 1) * PHASES] for k, f in enumerate(factors)}
    return (min((f for f, out in answers.items() if any(out)), default=math.inf),
            max((f for f, out in answers.items() if not all(out)), default=0.0))


def left_after_sticking(models, keywords, properties, degrees, contact_time, division=20, speed=0.1):
    """The most energy that is left after an elastic impact that sticks, over that before, of eight phases of the step."""
    angle, dt, spheres = math.radians(degrees), contact_time / division, []
    for phase in range(PHASES):
        late = (1 + phase / PHASES) * dt
        v = (-speed * math.cos(angle), speed * math.sin(angle), 0)
        y = -8e-3 + 2e-3 * phase
        spheres += [sphere((0, y, 0)), sphere((DIAMETER - v[0] * late, y - v[1] * late, 0), v)]
    text = script(spheres, f"{models} {keywords}", properties, dt=dt, steps=5 * division, every=5 * division,
                  contacts=contacts(1.0, friction=1e6))
    end = Run(text).frames("out.txt")[-1]
    most = 0.0
    for n in range(1, 2 * PHASES, 2):
        after = sum(math.hypot(*end[k][3:6])**2 + 0.4 * RADIUS**2 * math.hypot(*end[k][6:9])**2 for k in (n, n + 1))
        most = max(most, after / speed**2)
    return most
