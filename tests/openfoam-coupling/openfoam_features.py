# SPDX-License-Identifier: BSD-3-Clause
"""What OpenFOAM's own solvers can do, cohesiveBedFoam can: turbulence models, fvOptions, function objects
while it runs, and on what was written.

- Gas in a periodic box with a shear wave of small amplitude, through spheres that hardly act on it: k and
  epsilon of the k-epsilon model decay, and the wave by the viscosity that they make.
- A packed bed with a constant and a linear sink of momentum by fvOptions: the pressure drop it adds.
- simulationType laminar is what there is without turbulence properties."""

import re
import unittest

import numpy as np

from cohesion_tests import SOURCE
from cohesion_tests.coupling.cases import COUPLING, append
from cohesion_tests.coupling.dictionaries import FIELD, FILE, LAMINAR
from cohesion_tests.coupling.fields import field, uniform
from cohesion_tests.coupling.free_spheres import BLOCK
from cohesion_tests.coupling.held_layers import DT, G, RHO, ROW, ROWS, STEPS, SUPERFICIAL, drop, solid
from cohesion_tests.coupling.test_case import CoupledTestCase

# Shear wave: cells along an edge and their size [m]; start values of k, epsilon; amplitude [m/s]
N, H, K0, EPSILON0, WAVE = 8, 0.02, 1.0, 10.0, 1e-5
NU, WAVE_DT, WAVE_STEPS = 1e-3, 1e-3, 20
PAGE = SOURCE / "docs/openfoam-coupling/turbulence_and_sources.md"


def laminar(case):
    path = case.folder / "constant/turbulenceProperties"
    path.write_text(FILE.format("dictionary", path.name) + LAMINAR)
    append(case, "constant/transportProperties", "transportModel Newtonian;")
    append(case, "system/fvSchemes", "divSchemes { div(((voidFraction*nuEff)*dev2(T(grad(U))))) Gauss linear; }")


def recipe():
    """{file: text} of what the page says that k-epsilon takes."""
    return dict(re.findall(r"^```\n// (\S+)\n(.*?)^```$", PAGE.read_text(), re.M | re.S))


def k_epsilon(case, fields=True):
    """As the page says."""
    for file, text in recipe().items():
        if (case.folder / file).exists():
            append(case, file, text)
        elif not file.startswith("0/"):
            (case.folder / file).write_text(FILE.format("dictionary", file.split("/")[1]) + text)
        elif fields:
            name = file.split("/")[1]
            (case.folder / "0.orig" / name).write_text(FILE.format("volScalarField", name) + text)


def shear_wave(column):
    """k, epsilon and the wave's amplitude at the end of every step; one of each but for the wave."""
    case = column("shear_wave")
    block = case.folder / "system/blockMeshDict"
    block.write_text(block.read_text().split("// A column")[0] + BLOCK.format(N * H, N, N * H, N))
    cyclic = "".join(f"    {d}{i} {{ type cyclic; }}\n" for d in "xyz" for i in "01")
    z = (np.arange(N**3) // N**2 + 0.5) / N
    wave = "\n".join(f"({speed!r} 0 0)" for speed in (WAVE * np.sin(2 * np.pi * z)).tolist())
    fields = {
        "U": ("volVectorField", "[0 1 -1 0 0 0 0]", f"nonuniform List<vector> {N**3}\n(\n{wave}\n)"),
        "p": ("volScalarField", "[0 2 -2 0 0 0 0]", "uniform 0"),
        "voidFraction": ("volScalarField", "[0 0 0 0 0 0 0]", "uniform 1"),
        "k": ("volScalarField", "[0 2 -2 0 0 0 0]", f"uniform {K0}"),
        "epsilon": ("volScalarField", "[0 2 -3 0 0 0 0]", f"uniform {EPSILON0}"),
        "nut": ("volScalarField", "[0 2 -1 0 0 0 0]", "uniform 0"),
    }
    for name, (kind, dimensions, inside) in fields.items():
        (case.folder / "0.orig" / name).write_text(FIELD.format(kind, name, dimensions, inside, cyclic))
    k_epsilon(case, fields=False)
    case.set("constant/g", "value", "(0 0 0)")
    case.set("constant/transportProperties", "nu", NU)
    case.set(COUPLING, "dragFactor", 1e-15)
    case.set(COUPLING, "lammpsCoeffs/script", '"$FOAM_CASE/lattice.lmp"')
    variables = {"box": N * H, "height": N * H, "top": N * H, "spacing": H, "diameter": 0.8 * H, "density": 1000,
                 "dt": WAVE_DT, "cutoff": 0.4 * H}
    for variable, value in variables.items():
        case.set(COUPLING, f"lammpsCoeffs/variables/{variable}", f'"{value}"')
    for entry, value in (("PIMPLE/pRefCell", 0), ("PIMPLE/pRefValue", 0),
                         ('solvers/"U.*"/tolerance', 1e-14), ('solvers/"(k|epsilon).*"/tolerance', 1e-14)):
        case.set("system/fvSolution", entry, value)
    for entry, value in (("deltaT", WAVE_DT), ("endTime", WAVE_STEPS * WAVE_DT),
                         ("writeControl", "timeStep"), ("writeInterval", WAVE_STEPS)):
        case.set("system/controlDict", entry, value)
    case.mesh()
    case.solve()
    end = f"{WAVE_STEPS * WAVE_DT:g}"
    u = field(case, end, "U").reshape(-1, 3)[:, 0]
    amplitude = 2 * (u * np.sin(2 * np.pi * z)).mean()
    return [uniform(case, end, "k"), uniform(case, end, "epsilon"), amplitude]


def decay():
    """The same by the model's equations, dk/dt = -epsilon, d(epsilon)/dt = -1.92 epsilon^2/k, nut = 0.09
    k^2/epsilon, each in OpenFOAM's implicit Euler steps; and the wave by nu + nut on cells of size H."""
    k, epsilon, u = K0, EPSILON0, WAVE
    rate = (2 - 2 * np.cos(2 * np.pi / N)) / H**2
    for _ in range(WAVE_STEPS):
        u /= 1 + WAVE_DT * (NU + 0.09 * k**2 / epsilon) * rate
        epsilon /= 1 + 1.92 * WAVE_DT * epsilon / k
        k /= 1 + WAVE_DT * epsilon / k
    return [k, epsilon, u]


def bed(column, name, prepare=None, source="", functions=""):
    """The packed bed of packed_bed.py: case and log."""
    case = column(name)
    case.set(COUPLING, "lammpsCoeffs/script", '"$FOAM_CASE/packed.lmp"')
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-14)
    # What foamDictionary writes again has six digits.
    case.set("constant/transportProperties", "nu", 1.45e-5)
    case.set("0.orig/U", "boundaryField/bottom/superficialVelocity", f"(0 0 {SUPERFICIAL})")
    if prepare:
        prepare(case)
    if source:
        (case.folder / "constant/fvOptions").write_text(FILE.format("dictionary", "fvOptions") + source)
    with open(case.folder / "system/controlDict", "a") as control:
        control.write(functions)
    case.set("system/controlDict", "deltaT", DT)
    case.set("system/controlDict", "endTime", STEPS * DT)
    case.set("system/controlDict", "writeInterval", STEPS * DT)
    case.mesh()
    case.solve()
    return case


CONSTANT, LINEAR = 30.0, 40.0  # m/s2 and 1/s
SINK = f"""
sink
{{
    type vectorSemiImplicitSource;
    selectionMode all;
    volumeMode specific;
    injectionRateSuSp {{ U ((0 0 -{CONSTANT}) -{LINEAR}); }}
}}
"""
FUNCTIONS = """
functions
{
    outflow
    {
        type surfaceFieldValue;
        libs (fieldFunctionObjects);
        writeFields no;
        regionType patch;
        name top;
        operation sum;
        fields (voidFractionPhi);
    }
    heights
    {
        type probes;
        libs (sampling);
        fields (p voidFraction);
        probeLocations ((0.03 0.03 0.01) (0.03 0.03 0.05) (0.03 0.03 0.19));
    }
}
"""


def last_row(case, pattern):
    """Numbers of the last row of an output of function objects."""
    path, = (case.folder / "postProcessing").glob(pattern)
    rows = [line for line in path.read_text().splitlines() if not line.startswith("#")]
    return [float(word) for word in rows[-1].replace("(", " ").replace(")", " ").split()]


class OpenFoamFeatures(CoupledTestCase):
    def test_runs_as_the_page_says(self):
        case = self.column("recipe")
        k_epsilon(case)
        append(case, "system/controlDict", "endTime 5e-4; writeInterval 5e-4;")
        case.mesh()
        case.solve()
        for name in ("k", "epsilon", "nut"):
            file = case.folder / "0.0005" / name
            self.expect_true(f"recipe: {name} written", file.exists())
            if file.exists():
                found = field(case, "0.0005", name)
                self.expect_true(f"recipe: {name} from {found.min():.4g} to {found.max():.4g}, above zero",
                                 found.min() > 0)

    def function_objects(self, case):
        end = f"{STEPS * DT:g}"
        p = field(case, end, "p").reshape(len(ROWS), 3, 3)[:, 1, 1]
        # Six digits are written.
        time, flux = last_row(case, "outflow/0/surfaceFieldValue.dat")
        self.expect_near("surfaceFieldValue: flux through the top [m3/s]", flux, SUPERFICIAL * 9 * ROW**2, 1e-8)
        self.expect_near("at the end of the run", time, STEPS * DT, 1e-9)
        _, *found = last_row(case, "heights/0/p")
        for row, value in zip((0, 2, 9), found):
            self.expect_near(f"probe of p in row {row}", value, p[row], 1e-5 * abs(p[0]))
        self.expect_near("probe of the void fraction", last_row(case, "heights/0/voidFraction")[2],
                         1 - solid(ROWS[2]), 1e-5)
        bottom = field(case, end, "p")[:9].mean()
        for program in (("postProcess",), ("cohesiveBedFoam", "-postProcess")):
            case.run(*program, "-latestTime", "-func", "patchAverage(name=bottom,p)")
            text = case.log(program[0]).read_text()
            value = float(text.split("areaAverage(bottom) of p = ")[1].split()[0])
            # Free of spheres from the patch to the middle of the row: weight and sink
            self.expect_near(f"{' '.join(program)}: p at the bottom", value - bottom,
                             (G + CONSTANT + LINEAR * SUPERFICIAL) * ROW / 2, 1e-5 * value)
        self.expect_equal("states left as they were", sorted(x.name for x in case.folder.glob("incomplete*")), [])

    def test_shear_wave_decays(self):
        for what, found, right in zip(("k", "epsilon", "amplitude of the wave"), shear_wave(self.column), decay()):
            # Solved to 1e-14 in each of 20 steps and written with 12 digits; the wave makes k at a rate
            # below nut (2 pi/(N H) WAVE)^2/EPSILON0 < 1e-9 of what is lost.
            self.expect_near(what, found, right, 2e-9 * right)

    def test_sources_and_function_objects(self):
        plain = bed(self.column, "plain")
        sink = bed(self.column, "sink", source=SINK, functions=FUNCTIONS)
        end = f"{STEPS * DT:g}"
        # Per row eps grad p = ... - CONSTANT - LINEAR U, with eps U the superficial velocity; between the middles
        # of the end rows, which count half. The solver of p leaves 1e-14 of its scale, here some 1e-8 of the drop.
        eps = np.array([1 - solid(row) for row in ROWS])
        weight = np.array([0.5] + [1] * (len(ROWS) - 2) + [0.5])
        added = RHO * ROW * np.sum(weight * (CONSTANT / eps + LINEAR * SUPERFICIAL / eps**2))
        self.expect_near("pressure drop that the sink adds [Pa]", drop(sink, end) - drop(plain, end), added,
                         1e-6 * added)
        self.function_objects(sink)

        # laminar as a turbulence model
        through_model = bed(self.column, "laminar", prepare=laminar)
        self.expect_near("laminar: pressure drop [Pa]", drop(through_model, end), drop(plain, end),
                         1e-9 * drop(plain, end))


if __name__ == "__main__":
    unittest.main()
