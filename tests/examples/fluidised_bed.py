# SPDX-License-Identifier: BSD-3-Clause
"""fluidised_bed.py BUILD_FOLDER: the main job of examples/fluidised-bed against its expectations,
expected.csv there. Takes over the results when this very build has run the job already."""

import subprocess
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
BED = SOURCE / "examples/fluidised-bed"
sys.path[:0] = [str(BED), str(SOURCE / "examples/common"), str(SOURCE / "tests/openfoam-coupling")]

import analyse  # noqa: E402
import expected  # noqa: E402
import figures  # noqa: E402
from coupled_case import Expectations  # noqa: E402


def main(build):
    out = Path(build) / "fluidised-bed"
    command = [sys.executable, str(BED / "run.py"), "--build", build, "--out", str(out)]
    if subprocess.run(command).returncode != 0:
        # Results of another build or of other settings: replace them.
        subprocess.run([*command, "--overwrite"], check=True)

    expect = Expectations()
    results = {name: figures.evaluate(out / name) for name in ("non-cohesive", "Hamaker")}
    for line, holds in expected.held(BED / "expected.csv", {name: figures.single(found)
                                                            for name, found in results.items()}):
        expect.true(line, holds)

    free = results["non-cohesive"]
    low, high = free["ergun"]
    rising = free["velocities"].rising[0]
    expect.true(f"U_mf,th {rising:.3f} m/s inside Ergun's range {low:.3f} to {high:.3f} m/s at the "
                "void fraction of the resting bed +- its standard deviation", low <= rising <= high)
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
