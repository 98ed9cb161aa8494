# SPDX-License-Identifier: BSD-3-Clause
"""Smooth soft spheres that fix deform/shear shears at rate 1: runs, their balance of power, and their temperature
and stress against kinetic theory (sheared_spheres.py).

Springs and dashpots along the line of centres only (hooke/stiffness). Diameter 1; forces, energies and stresses are
given for spheres of mass 1."""

import math

import numpy

from cohesion_tests import dumps
from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import DENSITY, contact, script, sphere
from cohesion_tests.theory import sheared_spheres as theory
from cohesion_tests.thermo import thermo_lines

MODEL = "model hooke/stiffness tangential off tangential_damping off"
MASS = DENSITY * math.pi / 6
BLOCKS = 10
MEANS = ("T", "kinetic xx", "kinetic yy", "kinetic zz", "kinetic xy", "contact xx", "contact yy", "contact zz",
         "contact xy", "carried")
# Own velocity about the flow as it is driven: what shear takes from its energy, and that energy.
# The engine wants computes of contacts before the first run.
TOUCHING = "compute touching all pair/gran/local pos id delta\n"
OUTPUT = """fix shear all deform/shear rate 1 profile yes
run {before}
variable own atom vx-(y-0.5*ly)
variable carried atom mass*v_own*vy
variable energy atom 0.5*mass*(v_own*v_own+vy*vy+vz*vz)
compute carried all reduce sum v_carried
compute energy all reduce sum v_energy
compute flow all shear/profile
compute heat all temp
compute contact all pressure heat pair
fix mean all ave/time {sample} {number} {every} c_flow[3] c_flow[5] c_flow[6] c_flow[7] c_flow[8] c_contact[1] \
c_contact[2] c_contact[3] c_contact[4] c_carried
thermo {every}
thermo_style custom step atoms c_energy c_carried """ + " ".join(f"f_mean[{k}]" for k in range(1, 11)) + """
thermo_modify norm no lost error format float %.17g
"""
# Contacts in each step, beside the places and velocities of what is dumped.
EACH_CONTACT = """dump contacts all local 1 contacts.txt c_touching[1] c_touching[2] c_touching[3] c_touching[4] \
c_touching[5] c_touching[6] c_touching[7] c_touching[8] c_touching[10]
dump_modify contacts format "%.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
"""


def hard_enough(fraction, restitution, overlap, steps=15):
    """Contact that lasts a time in which two spheres that meet with the mean speed of approach, sqrt(pi T) of
    those that meet, would come nearer by `overlap` diameters; and a step, of which it takes `steps`."""
    T = theory.steady(fraction, restitution).temperature
    duration = overlap / math.sqrt(math.pi * T)
    return Contact(duration, restitution), duration / steps


class Contact:
    """Spring and dashpot by the duration of a contact, [1/rate], and its restitution."""

    def __init__(self, duration, restitution):
        self.duration, self.restitution = duration, restitution
        self.damping = -math.log(restitution) / duration  # eta/(2 mu), and mu = 1/2
        self.spring = ((math.pi / duration)**2 + self.damping**2) / 2

    def force(self, overlap, parting):
        """`parting`: speed at which the centres part."""
        return self.spring * overlap - self.damping * parting

    def diameter(self, temperature):
        """Of hard spheres with the structure and pressure of these, to first order in the duration: Barker and
        Henderson's (J. Chem. Phys. 47 (1967) 4714), 1 - integral of exp(-spring x^2/2T) over overlaps x > 0."""
        return 1 - math.sqrt(math.pi * temperature / (2 * self.spring))

    def properties(self):
        # gamman is for each reduced mass.
        return contact(stiffness=MASS * self.spring, gamman=2 * self.damping)

    def sampled_restitution(self, dt, phases=200):
        """Root of the mean squares, over all phases of the step in which the contact begins: what is left of an
        impact on the engine's grid, where the dashpot feels the speed of half a step before."""
        parting = -numpy.ones(phases)
        overlap = dt * (numpy.arange(phases) + 0.5) / phases
        while (overlap > 0).any():
            parting = parting + numpy.where(overlap > 0, 2 * dt * self.force(overlap, parting), 0)
            overlap = overlap - dt * parting
        return math.sqrt((parting**2).mean())


def length(side, fraction):
    return side * (math.pi / 6 / fraction)**(1 / 3)


def start(side, fraction, temperature):
    """side^3 spheres on a lattice with random velocities without net momentum."""
    random = numpy.random.default_rng(3)
    spacing = length(side, fraction) / side
    places = (numpy.array(numpy.meshgrid(*3 * [range(side)])).reshape(3, -1).T + 0.5) * spacing
    v = random.normal(0, math.sqrt(temperature), places.shape)
    return [sphere(x, w, radius=0.5) for x, w in zip(places, v - v.mean(axis=0))]


def run(side, fraction, law, temperature, dt, steps, before, sample, every, contacts=False, columns=("y",)):
    """Sheared for a strain `before`, then for `steps` with samples every `sample` steps and a line of their
    means every `every`: columns of the lines by name, per mass, and the Run. With `contacts` these and `columns`
    are dumped in each step."""
    box = length(side, fraction)
    setup = OUTPUT.format(before=round(before / dt / every) * every, sample=sample, number=every // sample, every=every)
    if contacts:
        setup = TOUCHING + setup + EACH_CONTACT
    done = Run(script(start(side, fraction, temperature), MODEL, dt=dt, skin=0.3, columns=columns, steps=steps,
                      boundary="p p p", box="0 {0!r} 0 {0!r} 0 {0!r} 0 0 0".format(box),
                      contacts=law.properties(), every=1 if contacts else steps, extra=setup))
    if done.code:
        raise AssertionError(done.output[-3000:])
    rows = numpy.array(thermo_lines(done.output)[1])
    if len(rows) != steps // every + 1 or (rows[:, 1] != side**3).any():
        raise AssertionError("spheres are missing:\n" + done.output[-3000:])
    table = dict(zip(("energy", "carried now", *MEANS), rows[:, 2:].T))
    return {name: values / (1 if name == "T" else MASS) for name, values in table.items()}, done


class Power:
    """Where the energy of the spheres' own motion goes, sums over the run: work of the shear by flights and by
    contacts, what it has gained, what contacts have taken."""

    def __init__(self, table, touches, volume, dt, every):
        steps = every * (len(table["energy"]) - 1)
        ends = table["carried now"]
        flights = every * table["carried"][1:].sum() + (ends[0] - ends[-1]) / 2
        self.work = -dt * (flights + every * volume * table["contact xy"][1:].sum())
        self.gained = table["energy"][-1] - table["energy"][0]
        self.taken = touches.taken[touches.step > touches.step.max() - steps].sum()
        self.rest = self.work - self.gained - self.taken


# What a Gaussian leaves out of the viscosity: 1.6 % of a dilute elastic gas (first Sonine approximation against the
# whole series, Chapman and Cowling, 1970, table 6: 1.016), less of a denser one, whose stress is carried by contacts
# that need second moments only. Mean squares and cubes of the approach are taken to be no worse.
TRUNCATION = 0.016
# What Enskog's equation leaves out, collisions that know of each other: of the viscosity, against molecular dynamics of
# elastic hard spheres at fractions up to 0.3 (Alder, Gass, Wainwright, J. Chem. Phys. 53 (1970) 3813). What contacts do
# at a given T it has from the pressure, which is known far better.
ENSKOG = 0.03
# T in the steady state goes as viscosity/dissipation, normal stress as T, shear stress as viscosity sqrt(T).
POWERS = {"stress xy": 1.5}
# Divided by the power of T with which they go.
OF_CONTACTS = ("contact stress", "dissipation")
AT_GIVEN_T = ("viscosity", *OF_CONTACTS)
# Barker and Henderson's diameter makes the pressure right to first order in the duration, but changes too much what
# encounters do: of its 1 - d a dilute gas needs the share pi/4 for the viscosity and 2/pi for the dissipation (Softness
# in sheared_spheres_test.py).
VISCOSITY_SHARE, DISSIPATION_SHARE = math.pi / 4, 2 / math.pi
SOFTNESS = 1 - min(VISCOSITY_SHARE, DISSIPATION_SHARE)
STANDARD_ERRORS = 4  # of ten blocks: 0.3 % lie beyond


def memories(fraction, restitution):
    """Strains in which deviations fall to 1/e: of T, the slowest, as heating goes as sqrt(T) and dissipation as
    T^(3/2); and of the stress at a given T, which the flow makes and collisions take, d(xy)/d(strain) = -yy -
    xy/memory."""
    state = theory.steady(fraction, restitution)
    return (1.5 * theory.density(fraction) * state.temperature / state.dissipation,
            -state.kinetic[0, 1] / state.kinetic[1, 1])


def standard_error(blocks, length):
    """Of the mean of blocks that are `length` memories long each, where correlation falls exponentially: the mean
    over x memories has the variance 2 s^2 g(x)."""
    def g(x):
        return (1 + math.expm1(-x) / x) / x
    count = len(blocks)
    whole = g(count * length)
    return blocks.std() * math.sqrt(whole / (g(length) - whole))


def compared(T, kinetic, impulsive, dissipation):
    """What is compared with theory, of stresses xx, yy, zz, xy along the first axis."""
    both = kinetic + impulsive
    return {"T": T, **{f"stress {c}": both[k] for k, c in enumerate(("xx", "yy", "zz", "xy"))},
            "viscosity": -both[3] / T**0.5, "contact stress": impulsive[:3].sum(axis=0) / T,
            "dissipation": dissipation / T**1.5}


def expected(fraction, law, dt):
    """What kinetic theory gives for hard spheres with the restitution of this grid, and for those that behave as
    these."""
    restitution = law.sampled_restitution(dt)
    hard = theory.steady(fraction, restitution)
    size = law.diameter(hard.temperature)
    soft = theory.steady(fraction * size**3, restitution)
    places = ([0, 1, 2, 0], [0, 1, 2, 1])
    # Its unit of length is `size`; the mass stays 1.
    return (compared(hard.temperature, hard.kinetic[places], hard.impulsive[places], hard.dissipation),
            compared(soft.temperature * size**2, soft.kinetic[places] / size, soft.impulsive[places] / size,
                     soft.dissipation / size))


def systematic(name, hard, soft):
    """Room that no sampling takes away, from both of `expected`: TRUNCATION, and ENSKOG where the viscosity decides; of
    finite contacts the part SOFTNESS of what they change to first order, and its square for what comes after."""
    change = abs(hard[name] / soft[name] - 1)
    theirs = TRUNCATION + (0 if name in OF_CONTACTS else ENSKOG)
    return POWERS.get(name, 1) * theirs + SOFTNESS * change + change**2


def against_theory(table, fraction, law, dt, every, volume):
    """[(name, measured over expected, room, standard error)]. The room: `systematic`, and STANDARD_ERRORS."""
    hard, soft = expected(fraction, law, dt)
    length = (len(table["T"]) - 1) // BLOCKS
    means = numpy.array([table[name][-BLOCKS * length:].reshape(BLOCKS, length).mean(axis=1) for name in MEANS])
    # What shear gives and the spheres do not keep.
    gained = numpy.diff(table["energy"][-BLOCKS * length - 1::length])
    strain = length * every * dt
    dissipation = -means[4] - means[8] - gained / strain / volume
    slow, fast = memories(fraction, law.restitution)
    found = []
    for name, blocks in compared(means[0], means[1:5], means[5:9], dissipation).items():
        ratios = blocks / soft[name]
        error = standard_error(ratios, strain / (fast if name in AT_GIVEN_T else slow))
        found.append((name, ratios.mean(), systematic(name, hard, soft) + STANDARD_ERRORS * error, error))
    return found


class Touches:
    """Pairs in contact in each step, a line each, from the dump, which knows places and overlaps: what the law of
    the contact makes of them. Speeds are those of the half steps between, by differences, and at both ends by a step
    with the law; overlap and speed of a pair are computed as if no other touched either."""

    def __init__(self, done, law, dt):
        frames = dumps.parse(done.files["contacts.txt"])
        table = numpy.concatenate([numpy.column_stack([numpy.full(len(frame.table), frame.step), frame.table])
                                   for frame in frames if len(frame.table)])
        # By pair, then by step.
        low, high = table[:, 7:9].min(axis=1), table[:, 7:9].max(axis=1)
        table = table[numpy.lexsort((table[:, 0], high, low))]
        pair = numpy.sort(table[:, 7:9], axis=1)
        goes_on = (numpy.diff(pair, axis=0) == 0).all(axis=1) & (numpy.diff(table[:, 0]) == 1)
        self.step, self.overlap = table[:, 0].astype(int), table[:, 9]
        overlap = self.overlap
        self.places = table[:, 1:7].reshape(-1, 2, 3)
        ahead = numpy.concatenate([numpy.where(goes_on, -numpy.diff(overlap) / dt, 0), [0]])
        # Leapfrog: u' = u + 2 dt F(overlap, u).
        back = (ahead - 2 * dt * law.spring * overlap) / (1 - 2 * dt * law.damping)
        first = ~numpy.concatenate([[False], goes_on])
        last = ~numpy.concatenate([goes_on, [False]])
        before = numpy.where(first, back, numpy.concatenate([[0], ahead[:-1]]))
        # Nothing is known of the speed in contacts of one step. Others last for fifteen: an end has cut these off, or
        # they graze, with an overlap that a tangential speed v opens in half a step, (v dt)^2/(8 d), about 1e-4 of
        # that of others, and hold nothing.
        once = first & last
        grazing = overlap[once & ~numpy.isin(self.step, (self.step.min(), self.step.max()))]
        if (grazing**2).sum() > 1e-6 * (overlap**2).sum():
            raise AssertionError(f"contacts of a single step, with overlaps of {grazing}")
        before[once] = 0
        self.force = law.force(overlap, before)
        after = numpy.where(last, before + 2 * dt * self.force, ahead)
        self.taken = -self.force * (before + after) / 2 * dt
        self.count = int(first.sum())
