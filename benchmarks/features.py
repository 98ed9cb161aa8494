# SPDX-License-Identifier: BSD-3-Clause
"""Feature x cost when off x cost when on, in instructions per particle and step: one scene without the
feature, with the feature set to nothing, and with it."""
import scenes
from cohesion_tests.progress import Progress
from scenes import LIGGGHTS_CONTACT, gran, hamaker, hooke, ours, overlay, well

HAMAKER_STYLE = f"hamaker cutoff {scenes.CUT} {scenes.OUT}"
WELL = "gran/squarewell"
WALL = f"stiffness {scenes.STIFFNESS} restitution {scenes.RESTITUTION} friction {scenes.FRICTION}"
PLANES = "zplane {low!r} {high!r}"


class Case:
    """One run: engine, lines of the pair style, lines behind the integrator."""

    def __init__(self, engine, pair, extra="", **options):
        self.engine, self.pair, self.extra, self.options = engine, pair, extra, options

    def text(self, scene, cells):
        return scenes.text(self.engine.startswith("liggghts"), scene, cells, self.pair, self.extra,
                           load=self.engine == "lammps+", **self.options)


def stock(pair, extra="", **options):
    return Case("lammps", pair, extra, **options)


def package(pair, extra="", **options):
    return Case("lammps+", pair, extra, **options)


def output(pair, define, delete, read=""):
    """Without, defined and deleted again, defined."""
    return package(pair), package(pair, define + delete), package(pair, define + read)


def cohesion(scheme, style, keywords, nothing):
    """In a style of this package: not named, of strength 0, of full strength."""
    return tuple(package(ours(style, scheme, cohesion=words)) for words in ("", nothing, keywords))


EXACT, SAMPLED = ours(cohesion=hamaker()), ours(scheme="sampled", cohesion=hamaker())
EVERY_STEP = "fix out all ave/time 1 10 10 c_out[*] mode vector file out.txt\n"
LIGGGHTS_HAMAKER = LIGGGHTS_CONTACT + " cohesion hamaker"
SAMPLED_WORDS = " scheme sampled"
LIGGGHTS_PAIR = scenes.LIGGGHTS_HAMAKER


def rolling(words):
    return package(ours(cohesion=hamaker(), rolling=words))


# feature: without it (the stock engine where it says so), with it and off, with it and on; None: there is no such run
LAMMPS = {
    "plugin loaded, no style used; without: stock": (stock(hooke()), package(hooke()), None),
    "gran/hamaker *sampled*, no cohesion; without: stock": (stock(hooke()), None, package(ours(scheme="sampled"))),
    "gran/hamaker *exact*, no cohesion; without: stock": (stock(hooke()), None, package(ours())),
    "hybrid/overlay hamaker; without: stock": (
        stock(hooke()), package(overlay(HAMAKER_STYLE, "hamaker 0")), package(overlay(HAMAKER_STYLE, f"hamaker {scenes.HAMAKER}"))),
    "hybrid/overlay squarewell; without: stock": (
        stock(hooke()), package(overlay("squarewell", f"well 0 {scenes.RATIO}")),
        package(overlay("squarewell", f"well {scenes.DEPTH} {scenes.RATIO}"))),
    "cohesion, gran/hamaker *exact*": cohesion("exact", "gran/hamaker", hamaker(), hamaker(0)),
    "cohesion, gran/hamaker *sampled*": cohesion("sampled", "gran/hamaker", hamaker(), hamaker(0)),
    "cohesion, gran/squarewell *exact*": cohesion("exact", WELL, well(), well(0)),
    "cohesion, gran/squarewell *sampled*": cohesion("sampled", WELL, well(), well(0)),
    "friction, *exact*": tuple(package(ours(friction=words, cohesion=hamaker()))
                               for words in ("", "friction 0", "friction 0.3")),
    "friction, *sampled*": tuple(package(ours(scheme="sampled", friction=words, cohesion=hamaker()))
                                 for words in ("", "friction 0", "friction 0.3")),
    "friction and history of the engine's own style": (
        stock(hooke(0, history=False)), stock(hooke(0)), stock(hooke())),
    "rolling friction, *exact*": tuple(map(rolling, ("", "rolling_friction 0", "rolling_friction 0.1"))),
    "ghost velocities, pair hamaker alone": tuple(
        ghosts and package(f"pair_style {HAMAKER_STYLE}\npair_coeff * * hamaker {scenes.HAMAKER}\n", ghosts=ghosts)
        for ghosts in ("no", None, "yes")),
    "wall/gran/hamaker, *exact*; without: no wall": (
        package(EXACT, walled=True), None,
        package(EXACT, f"fix w all wall/gran/hamaker {WALL} {hamaker()} {PLANES}\n", walled=True)),
    "wall of the engine; without: no wall": (
        stock(hooke(), walled=True), None,
        stock(hooke(), f"fix w all wall/gran hooke/history {scenes.STIFFNESS} NULL {scenes.GAMMA} NULL "
              f"{scenes.FRICTION} 1 {PLANES}\n", walled=True)),
    "energy tally, *exact*": output(EXACT, "compute out all gran/energy\n", "uncompute out\n"),
    "energy tally, *sampled*": output(SAMPLED, "compute out all gran/energy\n", "uncompute out\n"),
    "stress split, not read": output(EXACT, "compute out all gran/stress\n", "uncompute out\n"),
    "stress split, every step": output(EXACT, "compute out all gran/stress\n", "uncompute out\n", EVERY_STEP),
    "profile of the flow, every step": output(
        EXACT, "compute out all shear/profile\n", "uncompute out\n", EVERY_STEP.replace(" mode vector", "")),
    "agglomerates, every step": output(EXACT, "fix out all agglomerates 1\n", "unfix out\n"),
    "agglomerates, every 10": output(EXACT, "fix out all agglomerates 10\n", "unfix out\n"),
    "gas/coupling, no gas": output(EXACT, "fix out all gas/coupling\n", "unfix out\n"),
}
# `fix out` there is a cutoff (scenes.hamaker_properties).
LIGGGHTS = {
    "launcher, no model used; without: stock": (
        Case("liggghts", gran()), Case("liggghts+", gran()), None),
    "cohesion hamaker *sampled*; without: stock": (
        Case("liggghts", gran()),
        Case("liggghts+", gran(LIGGGHTS_HAMAKER + SAMPLED_WORDS, scenes.hamaker_properties(0.0))),
        Case("liggghts+", LIGGGHTS_PAIR)),
    "cohesion square_well *sampled*; without: stock": (
        Case("liggghts", gran()),
        Case("liggghts+", gran(LIGGGHTS_CONTACT + " cohesion square_well" + SAMPLED_WORDS, scenes.well_properties(0.0))),
        Case("liggghts+", gran(LIGGGHTS_CONTACT + " cohesion square_well" + SAMPLED_WORDS, scenes.well_properties()))),
    "cohesion sjkr of the engine": (
        Case("liggghts", gran()), None,
        Case("liggghts", gran(LIGGGHTS_CONTACT + " cohesion sjkr", scenes.SJKR_PROPERTIES))),
    "rolling epsd2 of the engine, with cohesion hamaker *sampled*": (
        Case("liggghts+", LIGGGHTS_PAIR), None,
        Case("liggghts+", gran(LIGGGHTS_HAMAKER + " rolling_friction epsd2" + SAMPLED_WORDS, scenes.hamaker_properties()))),
    **{f"energy tally, *{scheme}*": tuple(Case("liggghts+", pair, extra) for extra in (
        "", "compute out all gran/energy\nuncompute out\n", "compute out all gran/energy\n"))
       for scheme, pair in (("exact", scenes.LIGGGHTS_EXACT), ("sampled", LIGGGHTS_PAIR))},
    "agglomerates, every 10": tuple(Case("liggghts+", LIGGGHTS_PAIR, extra) for extra in (
        "", "fix done all agglomerates 10\nunfix done\n", "fix done all agglomerates 10\n")),
    "gas/coupling, no gas": tuple(Case("liggghts+", LIGGGHTS_PAIR, extra) for extra in (
        "", "fix done all gas/coupling\nunfix done\n", "fix done all gas/coupling\n")),
}
TABLES = {"LAMMPS": LAMMPS, "LIGGGHTS": LIGGGHTS}


def add_words(parser):
    parser.add_argument("--engine", choices=TABLES, action="append")
    parser.add_argument("--scene", choices=scenes.LATTICE, action="append")
    parser.add_argument("--feature", help="those alone whose name has this in it", default="")
    parser.add_argument("--particles", type=int, default=2048)
    parser.add_argument("--first", type=int, default=100, help="steps before what is counted")
    parser.add_argument("--steps", type=int, default=40, help="a multiple of 20")


def small(words):
    words.particles, words.scene, words.steps = 500, ["gas"], 20


def show(ratio, of):
    return "" if ratio is None else f"{ratio / of:.3f}"


def rows(programs, words):
    """Lines of the table, as they come."""
    engines = [e for e in words.engine or TABLES if programs.has(e.lower() + "+")]
    chosen = [(engine, name, cases, scene) for engine in engines
              for name, cases in TABLES[engine].items() if words.feature in name
              for scene in words.scene or scenes.LATTICE]
    progress, known = Progress(len(chosen)), {}
    yield "| engine | feature | scene | without | off | on | **off/without** | on/without |"
    yield "|---|---|---|---|---|---|---|---|"
    for engine, name, cases, scene in chosen:
        cells = scenes.cells_for(scene, words.particles)
        found = []
        for case in cases:
            text = case and case.text(scene, cells)
            if case and (case.engine, text) not in known:
                known[case.engine, text] = programs.count_per_step(
                    case.engine, text, words.first, words.steps) / scenes.particles(scene, cells)
            found.append(case and known[case.engine, text])
        yield (f"| {engine} | {name} | {scene} | "
               + " | ".join("" if f is None else f"{f:.0f}" for f in found)
               + f" | {show(found[1], found[0])} | {show(found[2], found[0])} |")
        progress.add(1)
