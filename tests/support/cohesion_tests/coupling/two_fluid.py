# SPDX-License-Identifier: BSD-3-Clause
"""Cases of twoPhaseEulerFoam for the tests of libcohesionTwoFluid: the example's, as a column of one row of cells that
gas and particles fill evenly, of an incompressible gas that slips along the walls."""

import re

from cohesion_studies.foam_case import FoamCase
from cohesion_tests import SOURCE

CASE = SOURCE / "examples/geldart-a-two-fluid/case"
LAMINAR = "simulationType laminar;\n"
SOLVER = "twoPhaseEulerFoam"


def edit(case, file, **entries):
    """Gives entries of a dictionary other values, each where it stands, once."""
    path = case.folder / file
    text = path.read_text()
    for name, value in entries.items():
        text, found = re.subn(rf"(?m)((?<![$\w]){name}\s+)[^;{{}}]*;", lambda m, new=value: f"{m[1]}{new};", text)
        assert found == 1, f"{file}: {found} entries '{name}'"
    path.write_text(text)


def nonuniform(values):
    """The values of a field, of scalars or of vectors, one for each cell, with all their digits."""
    def word(value):
        return repr(float(value)) if not hasattr(value, "__len__") else f"({' '.join(repr(float(x)) for x in value)})"

    kind = "vector" if hasattr(values[0], "__len__") else "scalar"
    return f"nonuniform List<{kind}> {len(values)} ({' '.join(map(word, values))})"


def replace(case, file, old, new):
    path = case.folder / file
    text = path.read_text()
    assert old in text, f"{file} has no '{old}'"
    path.write_text(text.replace(old, new))


def column(folder, env, cells, height, gas, grains, drag):
    """A column of `cells` cells [m]; gas: (density, viscosity), grains: (diameter, density), drag: words of its
    dictionary. Without the functions of the example."""
    case = FoamCase(CASE, folder, env, overwrite=True)
    edit(case, "system/blockMeshDict", height=height, columns=1, rows=cells, width=height / cells)
    replace(case, "0.orig/U.air", "walls { type noSlip; }", "walls { type slip; }")
    thermo = "constant/thermophysicalProperties."
    edit(case, thermo + "air", equationOfState="rhoConst", mu=repr(gas[1]))
    replace(case, thermo + "air", "specie { molWeight 28.9; }",
            f"specie {{ molWeight 28.9; }} equationOfState {{ rho {gas[0]!r}; }}")
    edit(case, thermo + "particles", rho=repr(grains[1]))
    replace(case, "constant/phaseProperties", "d 75e-6;", f"d {grains[0]!r};")
    path = case.folder / "constant/phaseProperties"
    path.write_text(re.sub(r"type +wenYu;\s+dragExponent +4.65;\s+dragFactor +1;", drag, path.read_text()))
    path = case.folder / "system/controlDict"
    text = path.read_text()
    path.write_text(text[:text.index("functions")])
    return case


def without_stress(case):
    """Particles that feel gas and gravity alone."""
    (case.folder / "constant/turbulenceProperties.particles").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties.particles; }\n" + LAMINAR)
    edit(case, "system/fvSolution", implicitPhasePressure="no")
    replace(case, "system/fvSchemes", "    default                         none;",
            "    default                         none;\n"
            "    div((((alpha.particles*thermo:rho.particles)*nuEff.particles)*dev2(T(grad(U.particles)))))"
            " Gauss linear;")


def times(case, step, end):
    step, end = repr(float(step)), repr(float(end))
    edit(case, "system/controlDict", deltaT=step, endTime=end, writeInterval=end, purgeWrite=0, writePrecision=14)
