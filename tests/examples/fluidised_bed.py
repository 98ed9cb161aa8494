# SPDX-License-Identifier: BSD-3-Clause
"""fluidised_bed.py BUILD_FOLDER: the main job of examples/fluidised-bed against its expectations,
expected.csv there. Takes over the results when this very build has run the job already."""

import dataclasses
import math
import subprocess
import sys
from pathlib import Path

from cohesion_studies import expected
from cohesion_studies.bed import analyse, figures
from cohesion_tests.coupling.cases import Expectations

SOURCE = Path(__file__).resolve().parents[2]
BED = SOURCE / "examples/fluidised-bed"

# Of the pressure drop: Ergun's viscous coefficient is 150, that of Macdonald et al. (Ind. Eng. Chem. Fundam. 18 (1979)
# 199) for packed smooth spheres 180; the inertial ones, 1.75 and 1.8, differ less.
SCATTER = 0.2


def ergun_and_tolerance(bed, found):
    """Ergun's velocity at the mean void fraction, and by how much that of the bed may differ from it: two standard
    errors of the void fraction and two of the bed's velocity, and what SCATTER makes of the velocity at which the
    pressure drop is the weight, in squares."""
    mean, _, error = found["void_fraction"]
    velocity = bed.minimum_fluidisation(mean)
    scattered = dataclasses.replace(bed, gravity=bed.gravity / (1 + SCATTER)).minimum_fluidisation(mean)
    parts = (2 * (bed.minimum_fluidisation(mean + error) - velocity), 2 * found["velocities"].rising[1],
             velocity - scattered)
    return velocity, math.hypot(*parts)


def main(build):
    out = Path(build) / "fluidised-bed"
    command = [sys.executable, str(BED / "run.py"), "--build", build, "--out", str(out)]
    if subprocess.run(command).returncode != 0:
        # Results of another build or of other settings: replace them.
        subprocess.run([*command, "--overwrite"], check=True)

    expect = Expectations()
    results = {name: figures.evaluate(out / name) for name in ("non-cohesive", "Hamaker")}
    held = expected.held(BED / "expected.csv", {name: figures.single(found) for name, found in results.items()})
    expect.true(f"{len(held)} rows of expected.csv, all there are, and the balance among them",
                len(held) == len(expected.rows(BED / "expected.csv")) and any("balance" in line for line, _ in held))
    for line, holds in held:
        expect.true(line, holds)

    free = results["non-cohesive"]
    rising = free["velocities"].rising[0]
    expect.near("U_mf,th, and Ergun's at the mean void fraction of the resting bed [m/s]", rising,
                *ergun_and_tolerance(analyse.Bed.read(out / "non-cohesive"), free))
    cohesive = results["Hamaker"]["velocities"].rising
    margin = 3 * (free["velocities"].rising[1] ** 2 + cohesive[1] ** 2) ** 0.5
    expect.true(f"cohesion raises U_mf,th: {cohesive[0]:.3f} m/s above {rising:.3f} m/s by more than "
                f"three standard errors of the fits ({margin:.3f} m/s)",
                cohesive[0] - rising > margin)
    for name in results:
        steps = analyse.curve(out / name)
        expect.equal(f"{name}: steps of the gas velocity", len(steps),
                     len(analyse.read_schedule(out / name)))
        expect.true(f"{name}: picture and table", (out / "result.png").stat().st_size > 10000
                    and "U_mf,th" in (out / "result.txt").read_text())
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:])
