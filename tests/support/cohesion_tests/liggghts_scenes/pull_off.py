# SPDX-License-Identifier: BSD-3-Clause
"""Grains that adhere and are pulled off by a load that grows slowly: at which load they part, over F_ad.

A grain begins at rest at F_ad/K, without a load, under a plate, in a cylinder, below another grain or under a plate of
triangles.
"""

import math

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl
from cohesion_tests.theory import slow_ramp
from cohesion_tests.theory.slow_ramp import CUT, DENSITY, OUT, TOP, A

PARTNERS = ("plane", "cylinder", "pair", "mesh")
LOADS = ("addforce", "gravity", "wall")


class Grain(slow_ramp.Grain):
    """A grain of slow_ramp; partner: one of PARTNERS."""

    models = "model hooke/stiffness tangential off cohesion hamaker"
    keywords = "absolute_damping on tangential_damping off"

    def properties(self):
        constants = {"kn": self.stiffness, "kt": self.stiffness, "gamman_abs": self.damping, "gammat_abs": 0.0,
                     "coefficientFriction": 0.5}
        return self.hamaker() + "".join(
            f"fix {name} all property/global {name} peratomtypepair 2 {value!r} {value!r} {value!r} {value!r}\n"
            for name, value in constants.items())

    @staticmethod
    def hamaker():
        return (f"fix A all property/global hamakerConstant peratomtypepair 2 {A} {3 * A!r} {3 * A!r} {A}\n"
                f"fix cut all property/global hamakerSurfaceCutoff scalar {CUT}\n"
                f"fix out all property/global hamakerOuterCutoff scalar {OUT}\n")

    def script(self, division, scheme, pulled_by):
        """division: steps per contact; pulled_by: addforce, gravity, or wall: a plate of triangles below, which attracts
        three times as much and moves away slowly with the grain."""
        d, steps = self.diameter, self.steps(division)
        side = 4 * d
        at_rest = self.overlap_at_rest
        near = (d if self.partner == "pair" else d / 2) - at_rest
        height = 2 * side - near
        dt = self.contact_time / division
        models, keywords = self.models, f"{self.keywords} scheme {scheme}"
        walls = {"plane": f"primitive type 1 zplane {2 * side!r}",
                 "cylinder": f"primitive type 1 xcylinder {side!r} {side!r} {side!r}",
                 "mesh": "mesh n_meshes 1 meshes plate"}
        wall = "" if self.partner == "pair" else f"fix wall all wall/gran {models} {walls[self.partner]} {keywords}\n"
        if self.partner == "mesh":
            wall = "fix plate all mesh/surface file plate.stl type 1\n" + wall
        load = f"{self.force * TOP!r}*(step/{steps})"
        loaded = f"{load}/{self.force!r}"
        if pulled_by == "gravity":
            pull = f"variable a equal {load}/{self.mass!r}\nfix pull all gravity v_a vector 0 0 -1\n"
        elif pulled_by == "wall":
            # Both springs give way, and F_ad lasts up to H_cut. A load presses a contact by F/K', somewhat more than
            # F/K; so a fifth longer.
            speed = -2 * TOP * at_rest / (steps * dt)
            steps = round(steps * (1.2 + CUT / (TOP * at_rest)))
            pull = ("fix low all mesh/surface/stress file low.stl type 2\n"
                    f"fix puller all wall/gran {models} mesh n_meshes 1 meshes low {keywords}\n"
                    f"fix away all move/mesh mesh low linear 0. 0. {speed!r}\n")
            loaded = f"f_low[3]/{self.force!r}"
        else:
            pull = (f"variable down equal -{load}\nvariable up equal {load}\nfix pull first addforce 0 0 v_down\n"
                    + ("fix hold second addforce 0 0 v_up\n" if self.partner == "pair" else ""))
        return (
            "units si\natom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
            f"communicate single vel yes\nregion box block 0 {2 * side!r} 0 {2 * side!r} 0 {2.5 * side!r} units box\n"
            f"create_box 2 box\nneighbor {d / 2!r} bin\nneigh_modify delay 0\n"
            + self.properties()
            + f"pair_style gran {models} {keywords}\npair_coeff * *\n"
            f"create_atoms 1 single {side!r} {side!r} {height:.17g} units box\n"
            + (f"create_atoms 1 single {side!r} {side!r} {2 * side!r} units box\n" if self.partner == "pair" else "")
            + f"set group all diameter {d!r} density {DENSITY}\ngroup first id 1\ngroup second id 2\n"
            + wall + pull + f"fix move all nve/sphere\ntimestep {dt!r}\n"
            f"variable gap equal {'z[2]-z[1]' if self.partner == 'pair' else f'{2 * side!r}-z[1]'}-{near!r}\n"
            f"variable load equal {loaded}\nthermo_style custom step v_gap v_load\n"
            f"thermo_modify format float %.9g lost ignore\nthermo {max(steps // 4000, 1)}\nrun {steps}\n")

    def load_at_parting(self, division, scheme="exact", pulled_by="addforce"):
        """Over F_ad; infinite where it does not part. Read to 0.0003 of it."""
        side = 8 * self.diameter
        # The lower plate touches the grain at its place of rest, three times as deep.
        low = side - self.diameter + 4 * self.overlap_at_rest
        inputs = {name: stl(rectangle((0, 0, z), (side, 0, 0), (0, side, 0), 3))
                  for name, z in (("plate.stl", side), ("low.stl", low))}
        run = Run(self.script(division, scheme, pulled_by), inputs=inputs)
        if run.code:
            raise AssertionError(run.output[-3000:])
        opened = self.overlap_at_rest + self.opens_by  # since the start
        before = 0.0
        for line in run.output.splitlines():
            words = line.split()
            if len(words) == 3 and words[0].isdigit():
                if float(words[1]) > opened:
                    return before if pulled_by == "wall" else float(words[2])
                before = float(words[2])
        return math.inf


def hertz_properties(grain):
    e = grain.restitution
    return (f"fix E all property/global youngsModulus peratomtype {grain.modulus!r} {grain.modulus!r}\n"
            "fix nu all property/global poissonsRatio peratomtype 0.25 0.25\n"
            f"fix e all property/global coefficientRestitution peratomtypepair 2 {e!r} {e!r} {e!r} {e!r}\n"
            "fix mu all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5\n")


class HertzGrain(Grain, slow_ramp.HertzGrain):
    """The same with model hertz: E [Pa], nu 0.25."""

    models = "model hertz tangential off cohesion hamaker"
    keywords = "tangential_damping off"

    def __init__(self, modulus, *words, **partner):
        self.modulus = modulus
        slow_ramp.HertzGrain.__init__(self, modulus, *words, **partner)

    def properties(self):
        return self.hamaker() + hertz_properties(self)


class JkrGrain(Grain, slow_ramp.JkrGrain):
    """The same with cohesion jkr: E [Pa], nu 0.25, surface energy [J/m2]."""

    models = "model hertz tangential off cohesion jkr"
    keywords = "tangential_damping off"

    def __init__(self, modulus, surface_energy, *words, **partner):
        self.modulus, self.gamma = modulus, surface_energy
        slow_ramp.JkrGrain.__init__(self, modulus, surface_energy, *words, **partner)

    def properties(self):
        g = self.gamma
        return (hertz_properties(self)
                + f"fix gamma all property/global surfaceEnergy peratomtypepair 2 {g!r} {3 * g!r} {3 * g!r} {g!r}\n")
