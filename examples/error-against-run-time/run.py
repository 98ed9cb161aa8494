#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error against run time of a scene: all schemes and steps side by side, a table, a plot, and the setting for a
wished error. Without SCENE all of the scenes beside this file.

    run.py [SCENE.yaml ...] [--wish ERROR] [--seeds N] [--steps SCHEME=A,B,...] [--set NAME=VALUE] [--out FOLDER]

README.md says what a scene file is.
"""

import argparse
from pathlib import Path

import compare
import job
import picture
from cohesion_studies import lammps_run, program
from cohesion_studies.progress_line import ProgressLine
from scene import QUANTITY, Scene, SceneError

HERE = Path(__file__).resolve().parent


class NothingFound(RuntimeError):
    """All runs of a scene have failed."""


def pair(word):
    name, separator, value = word.partition("=")
    if not separator or not name or not value:
        raise argparse.ArgumentTypeError(f"'{word}' is not NAME=VALUE")
    return name, value


def steps(word):
    name, value = pair(word)
    return name, value.split(",")


def arguments():
    entries = "\n".join(f"  {name:<20} {meaning}" for name, meaning in QUANTITY.items())
    parser = argparse.ArgumentParser(description=__doc__, epilog=f"entries of a quantity of a scene:\n{entries}",
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*", type=Path, metavar="SCENE.yaml")
    parser.add_argument("--wish", type=float, help="error that is good enough, in place of the scene's (0.01)")
    parser.add_argument("--seeds", type=int, help="how many, in place of the scene's")
    parser.add_argument("--steps", type=steps, action="append", default=[], metavar="SCHEME=A,B",
                        help="in place of the scene's")
    parser.add_argument("--set", type=pair, action="append", default=[], metavar="NAME=VALUE", dest="variables",
                        help="a variable of the script")
    parser.add_argument("--lmp", type=Path, nargs=2, metavar=("PROGRAM", "PLUGIN"),
                        help="in place of the stock engine of the build folder")
    program.folder_words(parser, "BUILD/error-against-run-time", "results")
    args = parser.parse_args()
    if args.wish is not None and not args.wish > 0:
        parser.error(f"--wish {args.wish}: it must be above zero")
    args.scenes = args.scenes or sorted((HERE / "scenes").glob("*.yaml"))
    args.out = program.out_folder(args, "error-against-run-time")
    return args


def measure(scene, engine, line):
    """Setting -> [Outcome of each run]. Every seed is a round of all settings, there and back in turns: what
    slows the machine for a while slows all of them."""
    results = {setting: [] for setting in scene.settings()}
    spent, count = {setting: 0.0 for setting in results}, 0
    for number, seed in enumerate(scene.rounds()):
        turn = list(results) if number % 2 else list(results)[::-1]
        for setting in turn:
            before = line.elapsed
            results[setting].append(job.run(scene, setting, seed, engine))
            spent[setting] += line.elapsed - before
            count += 1
            line.show(remaining(scene, results, spent),
                      f"{scene.name}, run {count} of {len(results) * len(scene.rounds())}")
    return results


def remaining(scene, results, spent):
    """Seconds left of a scene: a run takes what its setting took before; until then, time goes as 1/step."""
    done = {s: len(outcomes) for s, outcomes in results.items()}
    work = sum(done[s] / s.step for s in results)
    per_work = sum(spent.values()) / work
    total = len(scene.rounds())
    return sum((total - done[s]) * (spent[s] / done[s] if done[s] else per_work / s.step) for s in results)


def follow(scene, engine, args, line):
    """Runs a scene; writes and shows what comes out."""
    results = measure(scene, engine, line)
    rows = [(quantity, compare.rows(quantity, results, len(scene.seeds))) for quantity in scene.quantities]
    wishes = [args.wish or quantity.wish for quantity in scene.quantities]
    text = f"{scene.title}\n\n" + "\n".join(compare.report(scene, q, r, wish)
                                           for (q, r), wish in zip(rows, wishes))
    folder = args.out / scene.name
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "result.txt").write_text(text)
    (folder / "result.csv").write_text(compare.table(scene, rows))
    line.close()
    print(f"\n{text}\nin {folder}", flush=True)
    picture.draw(folder / "result.png", [(q.name, scene.step_unit, r, wish)
                                         for (q, r), wish in zip(rows, wishes)])
    return rows


def main():
    args = arguments()
    changes = {"variables": dict(args.variables), "steps": dict(args.steps), "seeds": args.seeds}
    # All are read before the first is run.
    scenes = [Scene(file, **changes) for file in args.scenes]
    engine = args.lmp or lammps_run.launcher(args.build)
    engine = job.Engine(*(Path(word).resolve() for word in (*engine, args.build)))
    line, empty = ProgressLine(), False
    for scene in scenes:
        rows = follow(scene, engine, args, line)
        empty = empty or all(row.failure for _, own in rows for row in own)
    if empty:
        raise NothingFound("a scene had no run that succeeded")


if __name__ == "__main__":
    program.run(main, SceneError, lammps_run.NotBuilt, NothingFound)
