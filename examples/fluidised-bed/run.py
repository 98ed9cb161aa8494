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
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))

import analyse  # noqa: E402
import picture  # noqa: E402
from foam_case import CaseError, FoamCase, environment  # noqa: E402
from progress_line import ProgressLine  # noqa: E402

POLL = 2.0  # s between looks at the logs


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--engine", choices=("lammps", "liggghts"), default="lammps",
                        help="particle engine (%(default)s)")
    parser.add_argument("--seed", type=int, default=None, metavar="N",
                        help="another realisation of the bed; for LIGGGHTS a prime above 10000")
    parser.add_argument("--beside", type=Path, default=None, metavar="FOLDER",
                        help="earlier results, of the other engine for instance, to stand beside "
                             "these in the table")
    parser.add_argument("--schedule", choices=("short", "thesis"), default="short",
                        help="gas velocity against time: the shortened cycle or the thesis's")
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


def make_case(name, hamaker, args, out, env):
    case = FoamCase(HERE / "case", out / name, env, overwrite=True)
    if args.schedule == "thesis":
        shutil.copy(case.folder / "constant/schedule.thesis", case.folder / "constant/schedule")
    coupling = "constant/couplingProperties"
    case.set(coupling, "demEngine", args.engine)
    case.set(coupling, f"{args.engine}Coeffs/variables/A", hamaker)
    if args.seed is not None:
        case.set(coupling, f"{args.engine}Coeffs/variables/seed", args.seed)
    case.mesh()
    (case.folder / "case.foam").touch()  # what ParaView opens
    return case


def fingerprint(build, env):
    """Of all that the results depend on, programs included: tells an earlier run of the same."""
    folders = [Path(f) for f in env["LD_LIBRARY_PATH"].split(":") if f.startswith(str(build))]
    files = [*(HERE / "case").rglob("*"), build / "openfoam/cohesiveBedFoam",
             *(f for folder in folders for f in folder.glob("*.so"))]
    digest = hashlib.sha256()
    for file in sorted(f for f in files if f.is_file()):
        digest.update(file.name.encode() + file.read_bytes())
    return digest.hexdigest()


def earlier_run(out, settings, overwrite):
    """Whether `out` holds the finished run of these settings; raises CaseError for another's."""
    record = out / "settings.json"
    if overwrite or not out.exists():
        return False
    if not record.exists() or json.loads(record.read_text())["settings"] != settings:
        raise CaseError(f"'{out}' holds the results of other settings: give --overwrite to replace "
                        "them, or --out for another folder")
    return json.loads(record.read_text())["finished"]


def watch(cases, processes):
    """One line with the share done and the time left, until all have ended."""
    line = ProgressLine()
    while any(process.poll() is None for process in processes.values()):
        time.sleep(POLL)
        if any(process.poll() for process in processes.values()):
            break  # One has failed: the others' results would not be used.
        parts, left = [], 0.0
        for name, case in cases.items():
            progress = case.progress()
            parts.append(f"{name} {100 * progress[0]:3.0f} %" if progress else f"{name} settling")
            left = max(left, progress[1]) if progress and left is not None else None
        line.show(left, ", ".join(parts))
    line.close()
    failed = [name for name, process in processes.items() if process.poll()]
    if failed:
        for process in processes.values():
            process.terminate()
    for name in failed or processes:
        cases[name].finish(processes[name])


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
        "seconds": analyse.solver_seconds(case),
    }


def main():
    args = arguments()
    args.build = args.build.resolve()
    out = args.out or args.build / ("fluidised-bed" if args.engine == "lammps"
                                    else f"fluidised-bed-{args.engine}")
    env = environment(args.build)
    settings = {"engine": args.engine, "schedule": args.schedule, "hamaker": args.hamaker,
                "seed": args.seed,
                "fingerprint": fingerprint(args.build, env)}
    record = out / "settings.json"
    kinds = {"non-cohesive": 0.0, "Hamaker": args.hamaker}
    if earlier_run(out, settings, args.overwrite):
        print(f"    the runs are done: taking them from {out}")
    else:
        cases = {name: make_case(name, a, args, out, env) for name, a in kinds.items()}
        record.write_text(json.dumps({"settings": settings, "finished": False}))
        watch(cases, {name: case.start() for name, case in cases.items()})
        record.write_text(json.dumps({"settings": settings, "finished": True}))

    results = {name: evaluate(out / name) for name in kinds}
    beside = {} if args.beside is None else {
        f"{name}, {args.beside.name}": evaluate(args.beside / name) for name in kinds}
    text = table({**results, **beside})
    (out / "result.txt").write_text(text + "\n")
    picture.draw(out, results)
    print(text)
    print(f"\npicture: {out / 'result.png'}\ntable:   {out / 'result.txt'}")
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    try:
        main()
    except CaseError as error:
        sys.exit(f"run.py: {error}")
