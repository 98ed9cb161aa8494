# SPDX-License-Identifier: BSD-3-Clause
"""Bad input to a coupled case, as in bad_input.py: meshes, gases, and what is observed."""

import unittest

from cohesion_tests.coupling.cases import COUPLING, edit
from cohesion_tests.coupling.test_case import CoupledTestCase

GAS = "constant/transportProperties"


def ideal_gas(case, pressure=1e5, temperature=300, weight=28.9):
    edit(case, GAS, "rho             1.205;", f"density idealGas; idealGas {{ pressure {pressure}; temperature"
         f" {temperature}; molWeight {weight}; }}")


# As in bad_input.py
CASES = {
    "particle outside the mesh": (
        lambda c: cut_mesh(c),
        ["1 particle is outside the mesh", "it is particle 1 at (0.031 0.029 0.19)"]),
    # The cells end in one of 4.3 mm of a height of 20 mm in the mean.
    "cell much smaller than the others, and denser than allowed": (
        lambda c: (edit(c, "system/blockMeshDict", "simpleGrading (1 1 1)", "simpleGrading (1 1 0.1)"),
                   c.run("blockMesh"), edit(c, "particles.lmp", "0.029 0.19", "0.029 0.198"),
                   c.set(COUPLING, "minVoidFraction", 0.99999999)),
        ["of cell 85 at (0.03 0.03 0.19", "% of the mean cell volume, 8e-06 m3",
         "A smoothingWidth of one particle diameter, 0.0001 m, cures it", "a lower minVoidFraction"]),
    "depth on a 3-D mesh": (
        lambda c: c.set(COUPLING, "depth", 1e-3),
        ["depth = 0.001", "2-D mesh", "3 dimensions"]),
    "depth below zero": (
        lambda c: c.set(COUPLING, "depth", -1e-3),
        ["depth = -0.001: must be a finite number greater than zero", "couplingProperties"]),
    "wedge": (
        lambda c: wedge_mesh(c),
        ["patch front of constant/polyMesh/boundary is a wedge", "make a 3-D mesh", "patches of type empty"]),
    "periodic by turning": (
        lambda c: periodic_mesh(c, turned=True),
        ["patch left of constant/polyMesh/boundary is a cyclic that does not lead to right by the length of the"
         " mesh along an axis", "opposite plane sides of the mesh"]),
    "periodic along no axis": (
        lambda c: periodic_mesh(c, inclined=10),
        ["patch left of constant/polyMesh/boundary is a cyclic that does not lead to right by the length of the"
         " mesh along an axis"]),
    "periodic on a part of a side": (
        lambda c: periodic_mesh(c, whole=False),
        ["patch left of constant/polyMesh/boundary is a cyclic on a part of a side of the mesh, which has sides"
         " beside it", "make the whole side cyclic"]),
    "periodic between sides of other faces": (
        lambda c: periodic_mesh(c, kind="cyclicAMI"),
        ["patch left of constant/polyMesh/boundary is a cyclicAMI", "make the faces of the two sides alike, and"
         " their type cyclic"]),
    "viscosity that turbulence cannot have": (
        lambda c: (c.folder / "constant/turbulenceProperties").write_text(
            "FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties; }\n"
            "simulationType laminar;\n"),
        ["transportModel is missing", "it must be Newtonian", "transportProperties"]),
    "steps of the gas that know older ones": (
        lambda c: edit(c, "system/fvSchemes", "ddtSchemes      { default Euler; }",
                       "ddtSchemes      { default backward; }"),
        ["ddtSchemes: default is backward", "must be Euler", "fvSchemes"]),
    "gas without viscosity": (
        lambda c: c.set(GAS, "nu", 0),
        ["viscosity of the gas = 0: must be a finite number greater than zero"]),
    "misspelt density": (
        lambda c: edit(c, GAS, "rho ", "density ideal; rho "),
        ["unknown density 'ideal'", "valid names: constant, idealGas", "transportProperties"]),
    "ideal gas without its numbers": (
        lambda c: edit(c, GAS, "rho ", "density idealGas; rhoThen "),
        ["density idealGas needs pressure", "temperature [K]; molWeight [kg/kmol]", "transportProperties"]),
    "ideal gas without its weight": (
        lambda c: (ideal_gas(c), edit(c, GAS, "molWeight", "weight")),
        ["density idealGas needs molWeight"]),
    "ideal gas that is not asked for": (
        lambda c: (ideal_gas(c), edit(c, GAS, "density idealGas;", "rho 1.2;")),
        ["idealGas is given, and without the entry density it is not used", "density constant",
         "transportProperties"]),
    "ideal gas without warmth": (
        lambda c: ideal_gas(c, temperature=0),
        ["temperature = 0: must be a finite number greater than zero", "transportProperties/idealGas"]),
    "ideal gas without pressure": (
        lambda c: ideal_gas(c, pressure=-1e5),
        ["pressure = -100000: must be a finite number greater than zero"]),
    "ideal gas without mass": (
        lambda c: ideal_gas(c, weight=0),
        ["molWeight = 0: must be a finite number greater than zero"]),
    "two densities": (
        lambda c: (ideal_gas(c), edit(c, GAS, "density", "rho 1.2; density")),
        ["rho is given", "it is 1.158", "remove the entry rho", "transportProperties"]),
    "more gas drawn than there is": (
        lambda c: (ideal_gas(c), edit(c, "0/p", "fixedValue; value", "fixedFluxPressure; value"),
                   edit(c, "0/U", "pressureInletOutletVelocity; value uniform (0 0 0)",
                        "fixedValue; value uniform (0 0 5000)")),
        ["the density of the gas would be -", "which no ideal gas can have", "reference pressure"]),
    # Vacuum is at -1/psi = -R T/M = -86310 m2/s2.
    "start in less than vacuum": (
        lambda c: (ideal_gas(c), edit(c, "0/p", "internalField   uniform 0;", "internalField uniform -9e4;")),
        ["p = -90000 in cells at time 0", "the density of the gas would be -0.0495", "p must be above -86309"]),
    "boundary in less than vacuum": (
        lambda c: (ideal_gas(c), edit(c, "0/p", "fixedValue; value uniform 0;",
                                      "fixedValue; value uniform -9e4;")),
        ["p = -90000 on patch top at time 0", "p must be above -86309"]),
    "inlet without area": (
        lambda c: edit(c, "0/U", "superficialVelocity (0 0 0);",
                       "superficialVelocity (0 0 0); share 0;"),
        ["share = 0", "must lie above 0"]),
    "layers of the bed thinner than cells": (
        lambda c: observe(c, "type bedHeight; layers 25;"),
        ["observed: layers = 25: layer 1 from the bottom, 0.008 m thick, holds no cell's centre",
         "not thinner than cells", "controlDict"]),
    "void fraction of a surface that there is not": (
        lambda c: observe(c, "type bedHeight; layers 10; limit 1;"),
        ["observed: limit = 1: must lie between 0 and 1", "controlDict"]),
    "grid without cells": (
        lambda c: observe(c, "type mixingIndex; cells (3 0 10);"),
        ["observed: cells = (3 0 10): must each be at least 1", "controlDict"]),
    "one colour": (
        lambda c: observe(c, "type mixingIndex; cells (3 3 10); layers 1;"),
        ["observed: layers = 1: must be at least 2", "controlDict"]),
    "heights in no direction": (
        lambda c: observe(c, "type mixingIndex; cells (3 3 10); direction (0 0 0);"),
        ["observed: direction = (0 0 0); give the direction in which heights are measured"]),
    "movement in no time": (
        lambda c: observe(c, "type particleMovement; interval 0;"),
        ["interval = 0: must be a finite number greater than zero", "controlDict"]),
    "forces of some steps": (
        lambda c: observe(c, "type forceBudget; executeControl timeStep; executeInterval 2;"
                             " writeControl timeStep; writeInterval 10;"),
        ["observed: the gas step 1 was left out", "without executeControl"]),
    "forces of no step": (
        lambda c: observe(c, "type forceBudget; executeControl none; writeControl timeStep; writeInterval 2;"),
        ["observed: the gas step", "was left out", "without executeControl"]),
}


def observe(case, entries):
    with open(case.folder / "system/controlDict", "a") as control:
        control.write(f"functions {{ observed {{ libs (cohesionFunctionObjects); {entries} }} }}\n")


def cut_mesh(case):
    """Takes the cells around the particle away, so that the mesh has a hole in its bounding box."""
    (case.folder / "system/topoSetDict").write_text(
        (case.folder / "system/decomposeParDict").read_text().split("numberOfSubdomains")[0]
        .replace("decomposeParDict", "topoSetDict")
        + "actions ({ name kept; type cellSet; action new; source boxToCell; box (0 0 0) (1 1 1); }"
          " { name kept; type cellSet; action subtract; source boxToCell;"
          " box (0.02 0.02 0.18) (0.04 0.04 1); });\n")
    case.run("topoSet")
    case.run("subsetMesh", "kept", "-patch", "sides", "-overwrite")


def wedge_mesh(case):
    """The column as a wedge around its edge."""
    path = case.folder / "system/blockMeshDict"
    path.write_text(path.read_text().split("scale")[0] + """
scale 0.001;
vertices ((0 0 0) (60 -2.6 0) (60 2.6 0) (0 0 200) (60 -2.6 200) (60 2.6 200));
blocks ( hex (0 1 2 0 3 4 5 3) (3 1 10) simpleGrading (1 1 1) );
boundary
(
    bottom { type patch; faces ((0 2 1 0)); } top { type patch; faces ((3 4 5 3)); }
    sides  { type wall;  faces ((1 2 5 4)); }
    front  { type wedge; faces ((0 1 4 3)); } back { type wedge; faces ((0 3 5 2)); } );
""")
    case.run("blockMesh")
    for file in (case.folder / "0").iterdir():
        file.write_text(file.read_text().replace(
            "boundaryField\n{", "boundaryField\n{ front { type wedge; } back { type wedge; }"))


def periodic_mesh(case, kind="cyclic", turned=False, inclined=0, whole=True):
    """The column with a periodic pair of sides: across x, or those that meet in the edge x = y = 0, one turned
    into the other; the side at the end of x as far up y as `inclined` [mm]; the upper half with walls."""
    low, middle, high = (" ".join(f"({x} {y} {z})" for x, y in
                                  ((0, 0), (60, inclined), (60, 60 + inclined), (0, 60))) for z in (0, 100, 200))
    left, right, near, far = ((f"({a} {b} {b + 4} {a + 4})", f"({a + 4} {b + 4} {b + 8} {a + 8})")
                              for a, b in ((3, 0), (1, 2), (0, 1), (2, 3)))
    if turned:
        right, near = near, right
    walls = [*near, *far]
    if not whole:
        walls += [left[1], right[1]]
        left, right = left[:1], right[:1]
    turn = "transform rotational; rotationAxis (0 0 1); rotationCentre (0 0 0);" if turned else ""
    path = case.folder / "system/blockMeshDict"
    path.write_text(path.read_text().split("scale")[0] + f"""
scale 0.001;
vertices ({low} {middle} {high});
blocks ( hex (0 1 2 3 4 5 6 7) (3 3 5) simpleGrading (1 1 1) hex (4 5 6 7 8 9 10 11) (3 3 5) simpleGrading (1 1 1) );
boundary
(
    bottom {{ type patch; faces ((0 3 2 1)); }} top {{ type patch; faces ((8 9 10 11)); }}
    sides  {{ type wall; faces ({" ".join(walls)}); }}
    left   {{ type {kind}; neighbourPatch right; {turn} faces ({" ".join(left)}); }}
    right  {{ type {kind}; neighbourPatch left; {turn} faces ({" ".join(right)}); }} );
""")
    case.run("blockMesh")
    for file in (case.folder / "0").iterdir():
        file.write_text(file.read_text().replace(
            "boundaryField\n{", f"boundaryField\n{{ left {{ type {kind}; }} right {{ type {kind}; }}"))


# What is found in a step
BEGUN = ("more gas drawn than there is", "forces of some steps", "forces of no step")
# After a complete step, which becomes a time folder
CONTINUED = ("forces of some steps", "forces of no step")


class BadGasAndMesh(CoupledTestCase):
    def test_each_is_refused(self):
        for number, (name, (spoil, parts)) in enumerate(CASES.items()):
            case = self.column(str(number))
            case.mesh()
            spoil(case)
            self.refused(name, case, *parts, begun=name in BEGUN, written=name in CONTINUED)


if __name__ == "__main__":
    unittest.main()
