# SPDX-License-Identifier: BSD-3-Clause
"""Grains that adhere and are pulled off by a load that grows slowly: at which load they part, over F_ad.

A grain of 1500 kg/m^3 begins at rest at F_ad/K, without a load, under a plate, in a cylinder, below another grain or
under a plate of triangles. The load grows steadily to 1.03 F_ad.
"""

import math

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl

A, CUT, OUT, DENSITY = 1e-19, 4e-10, 1e-7, 1500.0
TOP = 1.03
PARTNERS = ("plane", "cylinder", "pair", "mesh")


def rate_of_lag(lag, force, mass):
    """[1/s], of the load over F_ad. Beyond F_ad a mass is pulled by what the load is more, k t, through H_cut and as far
    again, where the tail is left behind; that takes (6 H_cut mu/(k F_ad))^(1/3), by which the load has grown by
    (6 H_cut mu k^2/F_ad)^(1/3)."""
    return math.sqrt(lag**3 * force / (6 * CUT * mass))


class Grain:
    """stiffness [N/m], restitution of the contact with any partner; diameter [m]."""

    def __init__(self, stiffness, restitution, diameter=75e-6, partner="plane", lag=1.5e-3):
        self.stiffness, self.diameter, self.partner = stiffness, diameter, partner
        self.mass = DENSITY * math.pi / 6 * diameter**3
        self.reduced_mass = self.mass / 2 if partner == "pair" else self.mass
        radius = diameter / 4 if partner == "pair" else diameter / 2
        self.force = A * radius / (6 * CUT**2)
        log = math.log(restitution)
        self.damping = -2 * log * math.sqrt(self.reduced_mass * stiffness / (math.pi**2 + log**2))
        alpha = self.damping / (2 * self.reduced_mass)
        self.contact_time = math.pi / math.sqrt(stiffness / self.reduced_mass - alpha**2)
        # Slow beside the contact, too: what it begins to swing by has gone.
        self.duration = TOP / min(rate_of_lag(lag, self.force, self.reduced_mass), 1 / (150 * self.contact_time))

    def script(self, division, scheme, pulled_by):
        """division: steps per contact; pulled_by: gravity or addforce."""
        d, steps = self.diameter, round(self.duration / self.contact_time * division)
        side = 4 * d
        near = (d if self.partner == "pair" else d / 2) - self.force / self.stiffness
        height = 2 * side - near
        models = "model hooke/stiffness tangential off cohesion hamaker"
        keywords = f"absolute_damping on tangential_damping off scheme {scheme}"
        walls = {"plane": f"primitive type 1 zplane {2 * side!r}",
                 "cylinder": f"primitive type 1 xcylinder {side!r} {side!r} {side!r}",
                 "mesh": "mesh n_meshes 1 meshes plate"}
        wall = "" if self.partner == "pair" else f"fix wall all wall/gran {models} {walls[self.partner]} {keywords}\n"
        if self.partner == "mesh":
            wall = "fix plate all mesh/surface file plate.stl type 1\n" + wall
        constant = {"kn": self.stiffness, "kt": self.stiffness, "gamman_abs": self.damping, "gammat_abs": 0.0,
                    "coefficientFriction": 0.5, "hamakerConstant": A}
        # Of a pair each gets half of its reduced mass's acceleration.
        load = f"{self.force * TOP!r}*(step/{steps})"
        pull = (f"variable a equal {load}/{self.mass!r}\nfix pull all gravity v_a vector 0 0 -1\n"
                if pulled_by == "gravity" else
                f"variable down equal -{load}\nvariable up equal {load}\nfix pull first addforce 0 0 v_down\n"
                + ("fix hold second addforce 0 0 v_up\n" if self.partner == "pair" else ""))
        return (
            "units si\natom_style granular\natom_modify map array\nboundary f f f\nnewton off\n"
            f"communicate single vel yes\nregion box block 0 {2 * side!r} 0 {2 * side!r} 0 {2.5 * side!r} units box\n"
            f"create_box 1 box\nneighbor {d / 2!r} bin\nneigh_modify delay 0\n"
            + "".join(f"fix {name} all property/global {name} peratomtypepair 1 {value!r}\n"
                      for name, value in constant.items())
            + f"fix cut all property/global hamakerSurfaceCutoff scalar {CUT}\n"
            f"fix out all property/global hamakerOuterCutoff scalar {OUT}\n"
            f"pair_style gran {models} {keywords}\npair_coeff * *\n"
            f"create_atoms 1 single {side!r} {side!r} {height:.17g} units box\n"
            + (f"create_atoms 1 single {side!r} {side!r} {2 * side!r} units box\n" if self.partner == "pair" else "")
            + f"set group all diameter {d!r} density {DENSITY}\ngroup first id 1\ngroup second id 2\n"
            + wall + pull + f"fix move all nve/sphere\ntimestep {self.contact_time / division!r}\n"
            f"variable gap equal {'z[2]-z[1]' if self.partner == 'pair' else f'{2 * side!r}-z[1]'}-{near!r}\n"
            f"thermo_style custom step v_gap\nthermo_modify format float %.9g lost ignore\nthermo {max(steps // 4000, 1)}\n"
            f"run {steps}\n"), steps, 2 * side

    def load_at_parting(self, division, scheme="event", pulled_by="addforce"):
        """Over F_ad; infinite where it does not part. Seen to 0.0003 of it."""
        script, steps, side = self.script(division, scheme, pulled_by)
        inputs = {"plate.stl": stl(rectangle((0, 0, side), (side, 0, 0), (0, side, 0), 3))}
        run = Run(script, inputs=inputs)
        if run.code:
            raise AssertionError(run.output[-3000:])
        opened = self.force / self.stiffness + 3 * CUT  # since the start
        for line in run.output.splitlines():
            words = line.split()
            if len(words) == 2 and words[0].isdigit() and float(words[1]) > opened:
                return TOP * int(words[0]) / steps
        return math.inf
