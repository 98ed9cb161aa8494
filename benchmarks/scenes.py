# SPDX-License-Identifier: BSD-3-Clause
"""Scenes in the words of both engines: equal spheres of 1 mm and 2650 kg/m^3 in a periodic box, a dense gas or
a packing; the same places and velocities in both.

The lists of neighbours are made every 20 steps, not when a particle has moved far enough: runs that differ
in what is measured then do not differ in their lists.
"""
import math
import statistics
from collections import namedtuple

DIAMETER, DENSITY, STIFFNESS, RESTITUTION, FRICTION = 1e-3, 2650.0, 800.0, 0.9, 0.3
HAMAKER, CUT, OUT = 7.49e-19, 4e-10, 1e-7
SURFACE_ENERGY = HAMAKER / (6 * CUT**2) / (4 * math.pi)  # [J/m^2]
DEPTH, RATIO = 5e-11, 1.01
REBUILD = 20
# Of two of them, mass m/2: pi/t_c is the frequency with damping, ln(1/e)/t_c its rate [s]
CONTACT_TIME = math.sqrt(DENSITY * math.pi / 12 * DIAMETER**3 / STIFFNESS
                         * (math.pi**2 + math.log(RESTITUTION)**2))
STEP = CONTACT_TIME / 20
GAMMA = -2 * math.log(RESTITUTION) / CONTACT_TIME  # damping of gran/hooke and gamman of hooke/stiffness [1/s]

SPACING = {"gas": DIAMETER * (4 * math.pi / 6 / 0.55)**(1 / 3), "packing": 0.999 * DIAMETER}
LATTICE = {"gas": ("fcc", 4), "packing": ("sc", 1)}
# From the first and the last layer of the lattice to planes there, in constants of the lattice
MARGIN, LAST = {"gas": 0.4, "packing": 0.5}, {"gas": 0.5, "packing": 1.0}
SPEED = {"gas": 0.2, "packing": 0.002}  # largest of a component [m/s]


def particles(scene, cells):
    """How many: `cells` along each edge of the box, or a tuple of three."""
    x, y, z = (cells,) * 3 if isinstance(cells, int) else cells
    return LATTICE[scene][1] * x * y * z


def planes(scene, cells):
    """Where walls across z are [m], each as far from the spheres as spheres are from each other."""
    return (-MARGIN[scene] * SPACING[scene], (cells - LAST[scene] + MARGIN[scene]) * SPACING[scene])


def cells_for(scene, wished):
    """Cells along the edge of the box for about so many particles."""
    return max(4, round((wished / LATTICE[scene][1])**(1 / 3)))


def text(liggghts, scene, cells, pair, extra="", load=False, walled=False, ghosts="yes"):
    """The script. pair: lines of the pair style; extra: lines behind the integrator, with {low} and {high} for
    where walls are to stand in a box that is walled across z."""
    kind, _ = LATTICE[scene]
    x, y, z = (cells,) * 3 if isinstance(cells, int) else cells
    speed, (low, high) = SPEED[scene], planes(scene, z)
    if walled:
        extra = extra.format(low=low, high=high)
    low_end, high_end = (low / SPACING[scene], high / SPACING[scene]) if walled else (0, z)
    return "".join((
        "plugin load ${plugin}\n" if load else "",
        "units si\n",
        "atom_style granular\natom_modify map array\n" if liggghts else "atom_style sphere\n",
        f"boundary p p {'f' if walled else 'p'}\nnewton off\n",
        "communicate single" if liggghts else "comm_modify", f" vel {ghosts}\n",
        f"lattice {kind} {SPACING[scene]!r}\n",
        f"region box block 0 {x} 0 {y} {low_end} {high_end} units lattice\n",
        "create_box 1 box\ncreate_atoms 1 box\n",
        f"set group all diameter {DIAMETER} density {DENSITY}\n",
        f"variable vx atom {speed}*sin(1e5*x+2e5*y+3e5*z)\n",
        f"variable vy atom {speed}*sin(2e5*x+3e5*y+1e5*z)\n",
        f"variable vz atom {speed}*sin(3e5*x+1e5*y+2e5*z)\n",
        "velocity all set v_vx v_vy v_vz\n",
        f"neighbor 1.5e-4 bin\nneigh_modify delay 0 every {REBUILD} check no\n",
        pair,
        f"fix move all nve/sphere\ntimestep {STEP!r}\n",
        extra,
        "thermo 1000000\nrun ${steps}\n"))


# --- LAMMPS ------------------------------------------------------------------------------------


def hooke(friction=FRICTION, history=True):
    """The engine's own contact, damped to the restitution."""
    style = "gran/hooke/history" if history else "gran/hooke"
    return (f"pair_style {style} {STIFFNESS} NULL {GAMMA} NULL {friction} {int(friction > 0)}\n"
            "pair_coeff * *\n")


def granular(cohesive=False):
    """The engine's modular style: the same contact, or one with the adhesion of Derjaguin, Muller and Toporov of
    the same force, 4 pi gamma R*."""
    normal = f"dmt 5e6 {GAMMA} 0.3 {SURFACE_ENERGY}" if cohesive else f"hooke {STIFFNESS} {GAMMA}"
    return ("pair_style granular\n"
            f"pair_coeff * * {normal} tangential linear_history {STIFFNESS * 2 / 7} 0.5 {FRICTION} "
            "damping mass_velocity\n")


def overlay(style, coefficients, contact=None):
    """An attraction of this package over the engine's contact."""
    name, *settings = (contact or hooke()).splitlines()[0].split()[1:]
    return (f"pair_style hybrid/overlay {name} {' '.join(settings)} {style}\n"
            f"pair_coeff * * {name}\npair_coeff * * {style.split()[0]} {coefficients}\n")


def ours(style="gran/hamaker", scheme="exact", friction=f"friction {FRICTION}", cohesion="", rolling=""):
    """A contact style of this package; friction, cohesion, rolling: keywords with their values."""
    return (f"pair_style {style} scheme {scheme}\npair_coeff * * stiffness {STIFFNESS} "
            f"restitution {RESTITUTION} {friction} {rolling} {cohesion}\n")


def hamaker(constant=HAMAKER):
    return f"hamaker {constant} cutoff {CUT} {OUT}"


def well(depth=DEPTH):
    return f"well {depth} {RATIO}"


# --- LIGGGHTS ----------------------------------------------------------------------------------

LIGGGHTS_CONTACT = "model hooke/stiffness tangential history"


def gran(models=LIGGGHTS_CONTACT, properties=""):
    """The engine's contact with models of its own and ours."""
    text = ""
    for name, value in {"kn": STIFFNESS, "kt": STIFFNESS * 2 / 7, "gamman": GAMMA, "gammat": GAMMA / 2,
                        "coefficientFriction": FRICTION, "coefficientRestitution": RESTITUTION,
                        "coefficientRollingFriction": 0.1}.items():
        text += f"fix {name} all property/global {name} peratomtypepair 1 {value!r}\n"
    text += "fix Y all property/global youngsModulus peratomtype 5e6\n"
    text += "fix nu all property/global poissonsRatio peratomtype 0.3\n"
    return text + properties + f"pair_style gran {models}\npair_coeff * *\n"


def hamaker_properties(constant=HAMAKER):
    return (f"fix A all property/global hamakerConstant peratomtypepair 1 {constant!r}\n"
            f"fix cut all property/global hamakerSurfaceCutoff scalar {CUT!r}\n"
            f"fix out all property/global hamakerOuterCutoff scalar {OUT!r}\n")


def well_properties(depth=DEPTH):
    return (f"fix D all property/global wellDepth peratomtypepair 1 {depth!r}\n"
            f"fix ratio all property/global wellRatio peratomtype {RATIO!r}\n")


SJKR_PROPERTIES = "fix k all property/global cohesionEnergyDensity peratomtypepair 1 1e4\n"
LIGGGHTS_HAMAKER = gran(LIGGGHTS_CONTACT + " cohesion hamaker scheme sampled", hamaker_properties())
LIGGGHTS_EXACT = gran(LIGGGHTS_CONTACT + " cohesion hamaker scheme exact", hamaker_properties())

# --- what growth and scaling compare -----------------------------------------------------------

WAYS = {
    "LAMMPS, gran/hooke/history (stock)": ("lammps", hooke()),
    "LAMMPS, gran/hamaker *exact*": ("lammps+", ours(cohesion=hamaker())),
    "LAMMPS, gran/hamaker *sampled*": ("lammps+", ours(scheme="sampled", cohesion=hamaker())),
    "LIGGGHTS, hooke/stiffness (stock)": ("liggghts", gran()),
    "LIGGGHTS, cohesion hamaker": ("liggghts+", LIGGGHTS_HAMAKER),
}


# `way`: of Programs; `wished`: the number of spheres that was asked for, of which `particles` came.
Run = namedtuple("Run", "name way text wished particles")


def gases(programs, words):
    """A Run of the gas for each of WAYS that is built and asked for (words.way) at each of words.sizes."""
    for name, (way, pair) in WAYS.items():
        if words.way not in name or not programs.has(way):
            continue
        for wished in words.sizes:
            cells = cells_for("gas", wished)
            script = text(way.startswith("liggghts"), "gas", cells, pair, load=way == "lammps+")
            yield Run(name, way, script, wished, particles("gas", cells))


def spread(values, digits=2):
    """Median (least to most); of one value that alone."""
    low, middle, high = (f"{value:.{digits}f}" for value in (min(values), statistics.median(values), max(values)))
    return f"{middle} ({low} to {high})" if len(values) > 1 else middle


def spread_words(turns):
    """What the heading of a column of spreads says of them."""
    return ": median (least to most)" if turns > 1 else ""
