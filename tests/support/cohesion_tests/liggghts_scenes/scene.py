# SPDX-License-Identifier: BSD-3-Clause
"""Scripts of spheres that fly, touch and meet walls, written from lists of particles.

Spheres of 1 mm and 2650 kg/m^3 of type 1 unless said otherwise; walls are of type 2.
"""

import math
import re

from cohesion_tests.liggghts import Run

RADIUS = 0.5e-3
DENSITY = 2650.0
MASS = DENSITY * 4 / 3 * math.pi * RADIUS**3
STIFFNESS, DAMPING = 800.0, 0.79e-3  # of hooke/stiffness between two spheres, [N/m] and [kg/s]
RATIO = 1.01  # r_out/r of the well
CUT, OUT = 1e-6, 2e-5  # of the Hamaker attraction
COLUMNS = "x y z vx vy vz omegax omegay omegaz fx fy fz tqx tqy tqz".split()

_START = """units si
dimension {dimension}
atom_style granular
atom_modify map array
boundary {boundary}
newton off
communicate single vel yes
region box {shape} {box} units box
create_box 2 box
neighbor {skin:.17g} bin
neigh_modify delay 0
"""


def _matrix(name, value, wall_value):
    return f"fix {name} all property/global {name} peratomtypepair 2 " + " ".join(
        repr(float(v)) for v in (value, wall_value, wall_value, value)) + "\n"


def contact(wall=1.0, stiffness=STIFFNESS, gamman=1000):
    """Properties of all contact models; `wall`: spring and dashpot of hooke/stiffness with a wall,
    over those of two spheres; stiffness, gamman: of that model."""
    text = """fix E all property/global youngsModulus peratomtype 5e6 5e6
fix nu all property/global poissonsRatio peratomtype 0.3 0.3
fix v all property/global characteristicVelocity scalar 1
"""
    for name, value in {"coefficientRestitution": 0.9, "coefficientFriction": 0.3,
                        "coefficientRollingFriction": 0.1}.items():
        text += _matrix(name, value, value)
    # Of gamman the dashpot is gamman times the reduced mass, of gamman_abs it is gamman_abs.
    for name, value in {"kn": stiffness, "kt": stiffness, "gamman": gamman, "gammat": 1000,
                        "gamman_abs": DAMPING, "gammat_abs": DAMPING}.items():
        text += _matrix(name, value, wall * value)
    return text


def hamaker(constant, wall=None, cut=CUT, out=OUT):
    """The properties of cohesion hamaker."""
    return (_matrix("hamakerConstant", constant, constant if wall is None else wall)
            + f"fix cut all property/global hamakerSurfaceCutoff scalar {float(cut)!r}\n"
            + f"fix out all property/global hamakerOuterCutoff scalar {float(out)!r}\n")


def square_well(depth, wall=None, ratio=RATIO):
    """The properties of cohesion square_well."""
    return (_matrix("wellDepth", depth, 2 * depth if wall is None else wall)
            + f"fix ratio all property/global wellRatio peratomtype {2 * (repr(float(ratio)) + ' ')}\n")


def surface_energy(energy):
    """The properties of cohesion jkr."""
    return _matrix("surfaceEnergy", energy, energy)


def liquid_bridge(force, gap):
    """The properties of cohesion liquid_bridge; beside a wall twice the force."""
    return _matrix("bridgeForce", force, 2 * force) + _matrix("bridgeRuptureGap", gap, gap)


def capillary(tension, angle, volume):
    """The properties of cohesion liquid_bridge with capillary on, the same for a wall."""
    return "".join(_matrix(name, value, value) for name, value in (
        ("bridgeSurfaceTension", tension), ("bridgeContactAngle", angle), ("bridgeVolume", volume)))


def sphere(place, velocity=(0, 0, 0), spin=(0, 0, 0), radius=RADIUS, density=DENSITY):
    return dict(place=place, velocity=velocity, spin=spin, radius=radius, density=density)


def with_scheme(models):
    """These models with scheme sampled, unless they name a scheme or have no cohesion of this package."""
    needs_one = re.search(r"cohesion (hamaker|square_well|liquid_bridge)", models) and " scheme " not in models
    return models + " scheme sampled" if needs_one else models


def script(spheres, models, properties="", walls=(), dt=1e-6, steps=0, every=1, skin=1e-4,
           boundary="f f f", box="-0.01 0.01 -0.01 0.01 -0.01 0.01", dump="out.txt",
           run=None, extra="", contacts=contact(), dimension=3, columns=tuple(COLUMNS)):
    """models: what follows `pair_style gran`, see with_scheme, and `fix wall/gran`; walls: what follows the models
    there, or whole lines for what a wall needs; run: in place of `run steps`; box: with the tilts
    xy, xz, yz behind its sides it is tilted."""
    shape = "prism" if len(box.split()) == 9 else "block"
    text = _START.format(boundary=boundary, box=box, skin=skin, shape=shape,
                         dimension=dimension) + "\n"
    for number, s in enumerate(spheres, 1):
        text += "create_atoms 1 single {:.17g} {:.17g} {:.17g} units box\n".format(*s["place"])
        text += f"set atom {number} diameter {2 * s['radius']:.17g} density {s['density']:.17g}"
        text += " vx {:.17g} vy {:.17g} vz {:.17g}".format(*s["velocity"])
        text += " omegax {:.17g} omegay {:.17g} omegaz {:.17g}\n".format(*s["spin"])
    text += contacts + properties
    text += f"pair_style gran {with_scheme(models)}\npair_coeff * *\n"
    for number, wall in enumerate(walls):
        text += wall + "\n" if wall.startswith("fix ") else (
            f"fix wall{number} all wall/gran {models} {wall}\n")
    text += f"fix move all nve/sphere\ntimestep {dt:.17g}\n{extra}"
    text += f"dump out all custom {every} {dump} id {' '.join(columns)}\n"
    text += f'dump_modify out format "%d{" %.17g" * len(columns)}" sort id\n'
    return text + (run if run is not None else f"run {steps}\n")


def part(row, what):
    """Three numbers of a dumped row: x (place), v (velocity), omega, f (force), tq (torque)."""
    first = COLUMNS.index("x" if what == "x" else what + "x")
    return row[first:first + 3]


def frames(spheres, models, *args, how="launcher", ranks=0, inputs=None, **kwargs):
    """Runs the script and gives its dumped frames; see Run.frames."""
    return Run(script(spheres, models, *args, **kwargs), how, ranks, inputs).frames("out.txt")
