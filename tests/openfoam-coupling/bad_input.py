# SPDX-License-Identifier: BSD-3-Clause
"""Bad input to a coupled case: each stops the solver before anything is computed or overwritten, and
says what is wrong, where, and what would be right."""

import os
import subprocess
import time
import unittest

from cohesion_tests.coupling.cases import CONTROL, COUPLING, ENGINE, append, script_file
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.refusals import assert_says
from cohesion_tests.theory.closure_formulas import CLOSURES

SCRIPT = script_file("particles")


def edit(case, file, old, new):
    path = case.folder / file
    text = path.read_text()
    assert old in text, f"{file} has no '{old}'"
    path.write_text(text.replace(old, new))


# name: (what makes the case bad, parts of the message)
# With either engine: what the adapters and the solver say of the script.
SCRIPT_CASES = {
    "script without the gas": (
        lambda c: edit(c, SCRIPT, "fix gas      all gas/coupling", ""),
        ["no fix gas/coupling", "add 'fix gas all gas/coupling'"]),
    "script in other units": (
        lambda c: edit(c, SCRIPT, "units        si", "units        cgs"),
        ["units cgs", "use 'units si'"]),
    "box of another size": (
        lambda c: edit(c, SCRIPT, "0 0.2", "0 0.3"),
        ["in direction z", "from 0 to 0.3 m", "the mesh from 0 to 0.2 m", "to less than a cell's width of 0.02 m"]),
    "periodic box of nearly the size": (
        lambda c: (edit(c, SCRIPT, "boundary     f f f", "boundary     f f p"), edit(c, SCRIPT, "0 0.2", "0 0.200001")),
        ["in direction z", "from 0 to 0.200001 m", "the mesh from 0 to 0.2 m", "to 2e-07 m"]),
    "variable that the solver sets": (
        lambda c: append(c, COUPLING, f'{ENGINE}Coeffs {{ variables {{ restart "settled.restart"; }} }}'),
        ["variables: 'restart' is set by the solver", "take another name, for instance 'settled'", "couplingProperties"]),
    "file of particles that only a continued run has": (
        lambda c: edit(c, SCRIPT, "create_box   1 box", "read_restart ${restart}"),
        ["In a new run the variable 'restart', which the solver sets, is 'none'", "another name"]),
    "script without gravity": (
        lambda c: edit(c, SCRIPT, "fix weight   all gravity 9.81 vector 0 0 -1", ""),
        ["gravity is (0 0 -9.81) m/s2 for the gas", "and (0 0 0) m/s2 for the particles",
         "'fix ID all gravity 9.81 vector 0 0 -1'", "'particleGravity any;'", "couplingProperties"]),
    "gravity along another axis": (
        lambda c: edit(c, SCRIPT, "gravity 9.81 vector 0 0 -1", "gravity 9.81 vector 0 -1 0"),
        ["gravity is (0 0 -9.81) m/s2 for the gas", "and (0 -9.81 0) m/s2 for the particles"]),
    "gravity of other digits": (
        lambda c: edit(c, SCRIPT, "gravity 9.81", "gravity 9.8"),
        ["gravity is (0 0 -9.81) m/s2 for the gas", "and (0 0 -9.8) m/s2 for the particles"]),
    "forces behind those of the gas": (
        lambda c: edit(c, SCRIPT, "fix gas      all gas/coupling",
                       "fix gas all gas/coupling\nfix late all addforce 0 0 1e-9"),
        ["has fix gas gas/coupling before fix late addforce", "put fix gas/coupling behind", "couplingProperties"]),
    "box that changes": (
        lambda c: (edit(c, SCRIPT, "boundary     f f f", "boundary     p f f"),
                   edit(c, SCRIPT, "fix gas      all gas/coupling", "fix df all deform 1 x scale 1.2\nfix gas all gas/coupling")),
        ["has fix df deform, which changes the simulation box", "remove the fix", "couplingProperties"]),
    "gas on none of the particles": (
        lambda c: edit(c, SCRIPT, "fix gas      all gas/coupling",
                       "region low block 0 0.06 0 0.06 0 0.1 units box\ngroup low region low\nfix gas low gas/coupling"),
        ["fix gas gas/coupling of the script", "acts on group low, and 1 of 1 particles are outside this group",
         "use 'fix gas all gas/coupling'", "couplingProperties"]),
    "gas on one of two particles": (
        lambda c: edit(c, SCRIPT, "fix gas      all gas/coupling", "create_atoms 1 single 0.031 0.029 0.05 units box\n"
                       "set group all diameter 1e-4 density 2000\ngroup first id 1\nfix air first gas/coupling"),
        ["fix air gas/coupling of the script", "acts on group first, and 1 of 2 particles are outside this group",
         "use 'fix air all gas/coupling'"]),
    "agglomerates that the script does not find": (
        lambda c: c.set(COUPLING, "agglomerateDrag", "equivalentSphere"),
        ["has no fix agglomerates", "add 'fix sets all agglomerates 1000'", "or take agglomerateDrag none",
         "couplingProperties"]),
    "script without a step": (
        lambda c: edit(c, SCRIPT, "timestep     ${dt}", "timestep     0"),
        ["has timestep 0", "give the command timestep a number greater than zero", "couplingProperties"]),
    "script of a negative step": (
        lambda c: edit(c, SCRIPT, "timestep     ${dt}", "timestep     -1e-5"),
        ["has timestep -0.00001", "give the command timestep a number greater than zero"]),
    "gas step that is no multiple": (
        lambda c: c.set("system/controlDict", "deltaT", 1.05e-4),
        ["deltaT = 0.000105", "10.5 steps", "whole multiple"]),
}

CASES = {
    "misspelt engine": (
        lambda c: c.set(COUPLING, "demEngine", "lamps"),
        ["unknown particle engine 'lamps'", "valid names: lammps, liggghts",
         "couplingProperties"]),
    "engine that was not built": (
        lambda c: without_adapters(c),
        ["this build has no particle engine 'liggghts'", "libcohesionLiggghtsEngine.so",
         "-DCOHESION_LIGGGHTS=ON", "'library' of liggghtsCoeffs", "couplingProperties"]),
    "missing engine": (
        lambda c: edit(c, COUPLING, "demEngine       lammps;", ""),
        ["demEngine", "couplingProperties"]),
    "misspelt drag": (
        lambda c: c.set(COUPLING, "drag", "syamlalObrien"),
        ["unknown drag 'syamlalObrien'", "valid names: " + ", ".join([*CLOSURES, "constantCd", "davidsonTaylor"])]),
    "coefficient of a closure that has its own": (
        lambda c: append(c, COUPLING, "dragCoefficient 0.44;"),
        ["dragCoefficient = 0.44: drag 'syamlalOBrien' has its own", "take drag constantCd", "couplingProperties"]),
    "closure without its coefficient": (
        lambda c: c.set(COUPLING, "drag", "constantCd"),
        ["dragCoefficient = 0: drag 'constantCd' needs it", "couplingProperties"]),
    "added mass below zero": (
        lambda c: append(c, COUPLING, "addedMass -0.5;"),
        ["addedMass = -0.5: must be a finite number greater than zero", "couplingProperties"]),
    "added mass of a word": (
        lambda c: append(c, COUPLING, "addedMass half;"),
        ["addedMass is 'half'", "off, on, or the coefficient C", "couplingProperties"]),
    "misspelt lift": (
        lambda c: append(c, COUPLING, "lift saffmanmei;"),
        ["unknown lift 'saffmanmei'", "valid names: none, inviscid, saffmanMei", "couplingProperties"]),
    "coefficient of no lift": (
        lambda c: append(c, COUPLING, "liftCoefficient 0.25;"),
        ["liftCoefficient goes with 'lift inviscid;', and lift is none", "couplingProperties"]),
    "exponent of a closure that has one of its own": (
        lambda c: (c.set(COUPLING, "drag", "diFelice"), c.set(COUPLING, "dragExponent", 9.6)),
        ["dragExponent = 9.6: drag 'diFelice' has no exponent to choose",
         "its exponent is a function of the Reynolds number",
         "take one of ergunWenYu, ergunRoweHenwood", "couplingProperties"]),
    "negative exponent": (
        lambda c: (c.set(COUPLING, "drag", "ergunWenYu"), c.set(COUPLING, "dragExponent", -4.65)),
        ["dragExponent = -4.65: must be a finite number greater than zero"]),
    "drag switched off": (
        lambda c: c.set(COUPLING, "dragFactor", 0),
        ["dragFactor = 0: must be a finite number greater than zero"]),
    "negative drag": (
        lambda c: c.set(COUPLING, "dragFactor", -1),
        ["dragFactor = -1: must be a finite number greater than zero"]),
    "misspelt mixture": (
        lambda c: c.set(COUPLING, "dragMixture", "vanderhoef"),
        ["unknown dragMixture 'vanderhoef'", "valid names: none, carmanKozeny, vanDerHoef"]),
    "misspelt law of agglomerates": (
        lambda c: c.set(COUPLING, "agglomerateDrag", "yes"),
        ["unknown agglomerateDrag 'yes'", "valid names: none, equivalentSphere", "couplingProperties"]),
    "agglomerates of parcels": (
        lambda c: append(c, COUPLING, "agglomerateDrag equivalentSphere; coarseGraining 2;"),
        ["agglomerateDrag equivalentSphere is a law of equal spheres", "coarseGraining above 1",
         "Remove one of the entries"]),
    "agglomerates in a mixture": (
        lambda c: append(c, COUPLING, "agglomerateDrag equivalentSphere; dragMixture carmanKozeny;"),
        ["agglomerateDrag equivalentSphere is a law of equal spheres", "a dragMixture"]),
    "agglomerates of bubbles": (
        lambda c: (c.set(COUPLING, "drag", "constantCd"),
                   append(c, COUPLING, "dragCoefficient 0.44; agglomerateDrag equivalentSphere;")),
        ["drag constantCd has one coefficient, for bubbles", "neither agglomerateDrag nor dragFilter",
         "Remove the entry, or take another drag"]),
    "misspelt filter": (
        lambda c: c.set(COUPLING, "dragFilter", "radl"),
        ["unknown dragFilter 'radl'", "valid names: none, radlSundaresan"]),
    "filter without gravity": (
        lambda c: (c.set(COUPLING, "dragFilter", "radlSundaresan"), c.set("constant/g", "value", "(0 0 0)")),
        ["dragFilter radlSundaresan goes by the speed at which grains fall", "constant/g is zero"]),
    "parcels smaller than grains": (
        lambda c: c.set(COUPLING, "coarseGraining", 0.5),
        ["coarseGraining: diameter of parcels over that of grains = 0.5: must be 1 or more"]),
    "misspelt form": (
        lambda c: c.set(COUPLING, "form", "C"),
        ["unknown form 'C'", "valid names: A, B"]),
    "misspelt slip": (
        lambda c: c.set(COUPLING, "slip", "cellMean"),
        ["unknown slip 'cellMean'", "valid names: cell, interpolated"]),
    "misspelt gravity": (
        lambda c: append(c, COUPLING, "particleGravity some;"),
        ["unknown particleGravity 'some'", "valid names: same, any", "couplingProperties"]),
    "misspelt response": (
        lambda c: c.set(COUPLING, "response", "stiff"),
        ["unknown response 'stiff'", "valid names: held, free", "couplingProperties"]),
    "misspelt void fraction": (
        lambda c: c.set(COUPLING, "voidFraction", "center"),
        ["unknown voidFraction 'center'",
         "valid names: particleCentre, dividedVolume, sphereOverlap", "couplingProperties"]),
    "smoothing over no width": (
        lambda c: c.set(COUPLING, "smoothingWidth", 0),
        ["smoothingWidth = 0: must be a finite number greater than zero", "couplingProperties"]),
    "adapter that cannot be loaded": (
        lambda c: c.set(COUPLING, "lammpsCoeffs/library", '"nowhere.so"'),
        ["cannot load the particle engine adapter 'nowhere.so'", "entry 'library'"]),
    "library that is no adapter": (
        lambda c: c.set(COUPLING, "lammpsCoeffs/library", '"libm.so.6"'),
        ["'libm.so.6' is not a particle engine adapter"]),
    "run without a step": (
        lambda c: edit(c, SCRIPT, "fix move     all nve/sphere", "fix low all wall/gran/hamaker stiffness 100 restitution "
                       "0.9 friction 0 hamaker 0 zplane 0 NULL\nfix move all nve/sphere\ntimestep 0\nrun 1"),
        ["fix low wall/gran/hamaker: timestep 0: give a time step above 0", "The particle engine ended the run"]),
    "plugin that cannot be loaded": (
        lambda c: c.set(COUPLING, "lammpsCoeffs/variables/plugin", "nowhere.so"),
        ["The particle engine ended the run", "log.lammps"]),
    "script that does not exist": (
        lambda c: c.set(COUPLING, "lammpsCoeffs/script", '"missing.lmp"'),
        ["script 'missing.lmp'", "does not exist"]),
    "script that is a folder": (
        lambda c: c.set(COUPLING, "lammpsCoeffs/script", '"system"'),
        ["script 'system' is a folder", "relative to the case folder"]),
    "script with points instead of spheres": (
        lambda c: (edit(c, SCRIPT, "atom_style   sphere", "atom_style   atomic"),
                   edit(c, SCRIPT, "set          group all diameter 1e-4 density 2000",
                        "mass 1 1e-9"),
                   edit(c, SCRIPT, "gran/hooke/history 100 NULL 0 NULL 0 0", "zero 1e-3"),
                   edit(c, SCRIPT, "nve/sphere", "nve"),
                   edit(c, SCRIPT, "fix gas      all gas/coupling", "")),
        ["has no spheres", "atom_style atomic"]),
    "script without particles": (
        lambda c: (edit(c, SCRIPT, "create_atoms 1 single 0.031 0.029 0.19", ""),
                   edit(c, SCRIPT, "set          group all diameter 1e-4 density 2000", "")),
        ["has no spheres", "0 particles"]),
    "gas step below the particle step": (
        lambda c: c.set("system/controlDict", "deltaT", 4e-6),
        ["deltaT = 4e-06", "whole multiple", "1e-05"]),
    "adjusted to no Courant number": (
        lambda c: (c.set("system/controlDict", "adjustTimeStep", "yes"),
                   c.set("system/controlDict", "maxCo", 0)),
        ["maxCo = 0: must be a finite number greater than zero", "controlDict"]),
    "only one time kept": (
        lambda c: c.set("system/controlDict", "purgeWrite", 1),
        ["purgeWrite = 1", "removes the last complete time", "Use 2 or more", "controlDict"]),
    "cell denser than allowed": (
        lambda c: c.set(COUPLING, "minVoidFraction", 0.99999999),
        # One sphere of 100 um in a cell of 8e-6 m3: 5.24e-13 m3, of which 8e-14 are allowed.
        ["1 cells have a void fraction below minVoidFraction = 0.99999999", "the lowest is",
         "of cell 85 at (0.03 0.03 0.19), of 8e-06 m3", "The solid beyond the limit is 4.43598", "nothing is clipped",
         "Cells of a few particle diameters cure it, voidFraction sphereOverlap, or, in a bed twenty widths high and"
         " more, a smoothingWidth"]),
    "cell denser than allowed, with all that smooths": (
        lambda c: append(c, COUPLING, "minVoidFraction 0.999999999; voidFraction sphereOverlap; smoothingWidth 0.01;"),
        ["Cells of a few particle diameters cure it, or, in a bed twenty widths high and more, a larger smoothingWidth"]),
    "pressure in Pa": (
        lambda c: edit(c, "0/p", "[0 2 -2 0 0 0 0]", "[1 -1 -2 0 0 0 0]"),
        ["0/p has the dimensions [1 -1 -2 0 0 0 0] and must have [0 2 -2 0 0 0 0]",
         "kinematic pressure p/rho in m2/s2; divide one in Pa by rho"]),
    "velocity without dimensions": (
        lambda c: edit(c, "0/U", "[0 1 -1 0 0 0 0]", "[0 0 0 0 0 0 0]"),
        ["0/U has the dimensions [0 0 0 0 0 0 0] and must have [0 1 -1 0 0 0 0]", "in m/s"]),
    "void fraction as a density": (
        lambda c: edit(c, "0/voidFraction", "[0 0 0 0 0 0 0]", "[1 -3 0 0 0 0 0]"),
        ["0/voidFraction has the dimensions [1 -3 0 0 0 0 0] and must have [0 0 0 0 0 0 0]"]),
    "gravity as a force": (
        lambda c: edit(c, "constant/g", "[0 1 -2 0 0 0 0]", "[1 1 -2 0 0 0 0]"),
        ["constant/g has the dimensions [1 1 -2 0 0 0 0] and must have [0 1 -2 0 0 0 0]"]),
    "no void fraction at all": (
        lambda c: c.set(COUPLING, "minVoidFraction", 0),
        ["minVoidFraction = 0: must be a finite number greater than zero", "couplingProperties"]),
}


# With LIGGGHTS: messages about the engine and its script.
LIGGGHTS_CASES = {
    "no dictionary of the engine": (
        lambda c: edit(c, COUPLING, "liggghtsCoeffs", "lammpsCoeffs2"),
        ["liggghtsCoeffs", "couplingProperties"]),
    "command that the engine does not know": (
        lambda c: edit(c, SCRIPT, "pair_coeff ", "pair_coef "),
        ["The particle engine ended the run", "log.liggghts"]),
    "cohesion without its parameters": (
        lambda c: edit(c, SCRIPT, "tangential off", "tangential off cohesion hamaker"),
        ["The particle engine ended the run", "log.liggghts"]),
    "script without particles": (
        lambda c: (edit(c, SCRIPT, "create_atoms 1 single 0.031 0.029 0.19 units box", ""),
                   edit(c, SCRIPT, "set          group all diameter 1e-4 density 2000", "")),
        ["has no spheres", "0 particles"]),
    "fix gas/coupling with a value": (
        lambda c: edit(c, SCRIPT, "all gas/coupling", "all gas/coupling drag"),
        ["The particle engine ended the run", "log.liggghts"]),
}


def times(case):
    return sorted(d.name for d in case.folder.iterdir() if d.is_dir() and d.name[0].isdigit())


def without_adapters(case):
    """The case names an engine whose adapter is not beside the coupling's library, a link to it."""
    library = "libcohesionCoupling.so"
    folders = case.env["LD_LIBRARY_PATH"].split(":")
    built = next(f for f in folders if os.path.exists(os.path.join(f, library)))
    (case.folder / library).symlink_to(os.path.join(built, library))
    case.env["LD_LIBRARY_PATH"] = ":".join([str(case.folder), *folders])
    case.set(COUPLING, "demEngine", "liggghts")


class BadInput(CoupledTestCase):
    def test_each_is_refused(self):
        cases = {**SCRIPT_CASES, **(CASES if ENGINE == "lammps" else LIGGGHTS_CASES)}
        for number, (name, (spoil, parts)) in enumerate(cases.items()):
            case = self.column(str(number))
            case.mesh()
            spoil(case)
            self.refused(name, case, *parts)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_existing_results_are_kept(self):
        case = self.column("results")
        case.mesh()
        case.solve()
        result = case.folder / "0.01/U"
        written = result.stat().st_mtime_ns
        self.refused("results of an earlier run", case, "already holds results", "0.01", "-overwrite")
        self.expect_equal("results of an earlier run: kept", result.stat().st_mtime_ns, written)
        case.solve("-overwrite")
        self.expect_true("with -overwrite: replaced", result.stat().st_mtime_ns > written)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_another_step_at_run_time(self):
        """deltaT in a controlDict that is read while the case runs."""
        case = self.column("modified")
        case.mesh()
        append(case, CONTROL, "runTimeModifiable yes; endTime 100; writeInterval 100;")
        process = case.start()
        log = case.log("cohesiveBedFoam")
        while process.poll() is None and "\nTime = " not in log.read_text():
            time.sleep(0.01)
        control = case.folder / "system/controlDict"
        changed = control.with_name("changed")
        changed.write_text(control.read_text() + "deltaT 2e-4;\n")
        # OpenFOAM wants a file to be ten seconds newer than the one it knows.
        os.utime(changed, (time.time() + 60, time.time() + 60))
        changed.replace(control)
        try:
            status = process.wait(timeout=60)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            status = 0
        self.expect_true("deltaT changed at run time: stops, and fails", status != 0)
        assert_says(self, log.read_text(), "the gas step is now deltaT = 0.0002 s", "set to 10 steps", "controlDict",
                    "startFrom latestTime")


if __name__ == "__main__":
    unittest.main()
