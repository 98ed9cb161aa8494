# SPDX-License-Identifier: BSD-3-Clause
"""Runs the fluidised bed without and with cohesion, both at once on one core each, and ends in a
table of the characteristic velocities and a picture.

    run.py [--engine liggghts] [--schedule thesis] [--hamaker A] [--seed N] [--beside FOLDER]
           [--out FOLDER] [--overwrite] [--build FOLDER]
"""

import argparse
import hashlib
import json
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))

import analyse  # noqa: E402
import picture  # noqa: E402
from foam_case import CaseError, FoamCase, environment  # noqa: E402
from job_pool import Job, RunError, carry_out  # noqa: E402

ENGINES = ("lammps", "liggghts")
SCHEDULES = ("short", "brief", "thesis")  # of the gas velocity
ENTRIES = ("voidFraction", "smoothingWidth")  # of couplingProperties that a bed may have of its own
MARK = "settings.json"  # in the folder of a case that was made here: it may be made anew


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--engine", choices=ENGINES, default=ENGINES[0],
                        help="particle engine (%(default)s)")
    parser.add_argument("--seed", type=int, default=None, metavar="N",
                        help="another realisation of the bed; for LIGGGHTS a prime above 10000")
    parser.add_argument("--beside", type=Path, default=None, metavar="FOLDER",
                        help="earlier results, of the other engine for instance, to stand beside "
                             "these in the table")
    parser.add_argument("--schedule", choices=SCHEDULES, default="short",
                        help="gas velocity against time: the shortened cycle, half of that, or the thesis's")
    parser.add_argument("--hamaker", type=float, default=7.49e-19, metavar="A",
                        help="Hamaker constant of the cohesive case [J] (%(default)s)")
    parser.add_argument("--out", type=Path, default=None,
                        help="folder for cases and results (BUILD/fluidised-bed, for LIGGGHTS "
                             "BUILD/fluidised-bed-liggghts)")
    parser.add_argument("--build", type=Path, default=HERE.parents[1] / "build",
                        help="build folder of the package")
    parser.add_argument("--overwrite", action="store_true",
                        help="replace the results of an earlier run")
    return parser.parse_args()


def make_case(folder, parameters, env):
    """The case of `parameters`: "engine", "schedule" (one of SCHEDULES), ENTRIES (a smoothingWidth of 0 is
    none), and variables of the engine's script."""
    case = FoamCase(HERE / "case", folder, env, overwrite=True)
    (case.folder / MARK).write_text(json.dumps(parameters))
    coupling, engine = "constant/couplingProperties", parameters["engine"]
    case.set(coupling, "demEngine", engine)
    if parameters["schedule"] != "short":
        shutil.copy(case.folder / f"constant/schedule.{parameters['schedule']}", case.folder / "constant/schedule")
    for name, value in parameters.items():
        if name in ENTRIES:
            if value:
                case.set(coupling, name, value)
        elif name not in ("engine", "schedule"):
            case.set(coupling, f"{engine}Coeffs/variables/{name}", value)
    case.mesh()
    (case.folder / "case.foam").touch()  # what ParaView opens
    return case


class BedRun(Job):
    """One bed: its case, made anew when it starts."""

    def __init__(self, folder, parameters, env, fingerprint):
        super().__init__(folder, {**parameters, "fingerprint": fingerprint})
        self.parameters, self.env = parameters, env

    def start(self):
        self.case = make_case(self.folder, self.parameters, self.env)
        return self.case.start()

    def figures(self):
        """Those of evaluate() that are one number."""
        found = evaluate(self.folder)
        velocities = found["velocities"]
        return {"U_mf_df": velocities.falling[0], "U_mf_th": velocities.rising[0],
                "U_mf_in": velocities.at_maximum, "overshoot": velocities.overshoot,
                "pressure_over_weight": found["plateau"][0], "balance": found["balance"][0],
                "void_fraction": found["void_fraction"][0], "mixing": found["mixing"][0],
                "mixed": found["mixing"][1], "movement": found["movement"][0], "movement_at": found["movement"][1],
                "pressure_noise": found["noise"], "exchange_ms_per_step": found["exchange_ms"]}

    def share(self):
        progress = self.case.progress()
        return progress[0] if progress else 0.0

    def tail(self):
        return self.case.tail()


def fingerprint(build, env):
    """Of all that the results depend on, programs included: tells an earlier run of the same."""
    folders = [Path(f) for f in env["LD_LIBRARY_PATH"].split(":") if f.startswith(str(build))]
    files = [*(HERE / "case").rglob("*"), build / "openfoam/cohesiveBedFoam",
             *(f for folder in folders for f in folder.glob("*.so"))]
    digest = hashlib.sha256()
    for file in sorted(f for f in files if f.is_file()):
        digest.update(file.name.encode() + file.read_bytes())
    return digest.hexdigest()


def require_ours(jobs):
    """Raises CaseError when a folder holds the results of other settings, or something else."""
    for job in jobs:
        if not job.folder.exists() or job.result() is not None:
            continue
        if (job.folder / "result.json").exists() or not (job.folder / MARK).exists():
            raise CaseError(f"'{job.folder}' holds something else than results of these settings: give "
                            "--overwrite to replace it, or --out for another folder")


def table(results):
    rows = [("", *results)]

    def with_error(value):
        return f"{value[0]:.3f} +- {value[1]:.3f}"

    rows.append(("U_mf,df  falling branch [m/s]",
                 *(with_error(r["velocities"].falling) for r in results.values())))
    rows.append(("U_mf,th  rising branch [m/s]",
                 *(with_error(r["velocities"].rising) for r in results.values())))
    rows.append(("U_mf,in  pressure maximum [m/s]",
                 *(f"{r['velocities'].at_maximum:.3f}" for r in results.values())))
    rows.append(("overshoot of the pressure drop",
                 *(f"{r['velocities'].overshoot:+.3f}" for r in results.values())))
    rows.append(("pressure drop / weight, fluidised",
                 *(with_error(r["plateau"]) for r in results.values())))
    rows.append(("same with plate and walls added",
                 *(with_error(r["balance"]) for r in results.values())))
    rows.append(("void fraction of the resting bed",
                 *(with_error(r["void_fraction"]) for r in results.values())))
    rows.append(("Ergun's U_mf for it [m/s]",
                 *("{:.3f} to {:.3f}".format(*r["ergun"]) for r in results.values())))
    rows.append(("seconds, of these in the particle engine",
                 *("{:.0f}, {:.0f}".format(*r["seconds"]) for r in results.values())))
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths))
                     for row in rows)


def evaluate(case):
    steps = analyse.curve(case)
    velocities = analyse.velocities(steps)
    plateau, balance = analyse.plateau(case, velocities)
    mean, deviation = analyse.packed_void_fraction(case)
    return {
        "steps": steps,
        "velocities": velocities,
        "plateau": plateau,
        "balance": balance,
        "void_fraction": (mean, deviation),
        "ergun": [analyse.ergun_minimum_fluidisation(mean + s * deviation) for s in (-1, 1)],
        "mixing": analyse.mixing(case),
        "movement": analyse.movement(case),
        "noise": analyse.pressure_noise(case),
        "exchange_ms": analyse.exchange_milliseconds(case),
        "seconds": analyse.solver_seconds(case),
    }


def earlier(folder, kinds):
    """Of the cases `kinds` in a folder of results; raises CaseError."""
    try:
        return {f"{name}, {folder.name}": evaluate(folder / name) for name in kinds}
    except (OSError, LookupError, ValueError) as error:
        raise CaseError(f"--beside '{folder}' holds no results of this program: {error!r}") from None


def main():
    args = arguments()
    args.build = args.build.resolve()
    out = args.out or args.build / ("fluidised-bed" if args.engine == "lammps"
                                    else f"fluidised-bed-{args.engine}")
    env = environment(args.build)
    mark = fingerprint(args.build, env)
    common = {"engine": args.engine, "schedule": args.schedule}
    if args.seed is not None:
        common["seed"] = args.seed
    kinds = {"non-cohesive": 0.0, "Hamaker": args.hamaker}
    beside = {} if args.beside is None else earlier(args.beside, kinds)
    jobs = [BedRun(out / name, {**common, "A": a}, env, mark) for name, a in kinds.items()]
    if args.overwrite:
        for job in jobs:
            job.discard()
    else:
        require_ours(jobs)
    carry_out(jobs, together=len(jobs))

    results = {name: evaluate(out / name) for name in kinds}
    text = table({**results, **beside})
    (out / "result.txt").write_text(text + "\n")
    picture.draw(out, results)
    print(text)
    print(f"\npicture: {out / 'result.png'}\ntable:   {out / 'result.txt'}")
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    try:
        main()
    except RunError as error:
        sys.exit(f"run.py: {error}")
