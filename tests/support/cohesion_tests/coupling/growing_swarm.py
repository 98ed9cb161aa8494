# SPDX-License-Identifier: BSD-3-Clause
"""What the exchange of gas and particles costs a rank as the problem grows with the ranks: a blown-through
swarm, 20 mm x 20 mm x 60 mm with 768 spheres and 192 cells to a rank, the ranks side by side. The ranks that
have the particles are cut a quarter of that beside those that have the gas."""

import re

from cohesion_tests.coupling.cases import COUPLING, exchange_lines, use_script

EDGE, HEIGHT = 0.02, 0.06  # of the part of a rank [m]
SPHERES = 8 * 8 * 12
CELLS = (4, 4, 12)
SHIFT = 0.25  # of the particles' ranks beside the gas's, parts of a rank
DT = 1e-4
# With this shift a rank's particles are in the cells of four ranks at most, and its cells have the particles of
# four. To those of the first kind go, one message each: how many questions, the questions, the verdicts, and
# volume, coefficient, charge and, in form A, the volume whose pressure they hand on, of the particles; and of kernels
# that reach out the sum of the shares. Back go the answers, void fraction and velocity for the drag, velocity and
# pressure gradient at the end of the step and, in form A, the pressure gradient that the gas was charged with.
NEIGHBOURS = 4
FORWARD, BACK = {"particleCentre": 7, "dividedVolume": 8, "sphereOverlap": 8}, 6
# The state that a run keeps after its first step has the particles located once more: how many questions, the questions
# and the verdicts, and the answers.
KEPT = 4


def grid(ranks):
    """Ranks along x and y, as nearly square as they can be."""
    along_y = max(n for n in range(1, int(ranks**0.5) + 1) if ranks % n == 0)
    return ranks // along_y, along_y


def cuts(along):
    """LAMMPS' words that shift the borders of the ranks."""
    words = [f"{axis} " + " ".join(repr((k + SHIFT) / n) for k in range(1, n))
             for axis, n in zip("xy", along) if n > 1]
    return "balance 0.9 " + " ".join(words) + "\n" if words else ""


def make(column, ranks, steps, kernel):
    case = column(f"ranks-{ranks}")
    along = grid(ranks)
    mesh = case.folder / "system/blockMeshDict"
    x, y = (1000 * EDGE * n for n in along)
    text = re.sub(r"vertices\s*\(.*?\);\n", "vertices\n(\n" + "".join(
        f"    ({a:g} {b:g} {c:g})\n" for c in (0, 1000 * HEIGHT) for a, b in ((0, 0), (x, 0), (x, y), (0, y)))
        + ");\n", mesh.read_text(), flags=re.S)
    cells = [n * c for n, c in zip((*along, 1), CELLS)]
    mesh.write_text(text.replace("(3 3 10)", "({} {} {})".format(*cells)))
    use_script(case, "growing")
    (case.folder / "cuts").write_text(cuts(along))
    for name, value in (("edge_x", EDGE * along[0]), ("edge_y", EDGE * along[1]), ("ranks_x", along[0]),
                        ("ranks_y", along[1])):
        case.set(COUPLING, f"lammpsCoeffs/variables/{name}", value)
    case.set(COUPLING, "voidFraction", kernel)
    case.set("0.orig/U", "boundaryField/bottom/superficialVelocity", "(0 0 0.5)")
    case.set("system/controlDict", "endTime", steps * DT)
    case.set("system/controlDict", "deltaT", DT)
    case.set("system/controlDict", "writeInterval", 1)  # nothing is written
    # Ranks that share a core wait for each other in every iteration of the solver, and what is counted here
    # does not depend on the gas.
    case.set("system/fvSolution", 'solvers/"p.*"/maxIter', 2)
    case.set("system/fvSolution", 'solvers/"U.*"/maxIter', 1)
    case.set("system/decomposeParDict", "coeffs/n", "({} {} 1)".format(*along))
    case.mesh()
    return case


def sent(log):
    """Mean and largest over the ranks, per step; of one rank nothing."""
    found = {name: tuple(map(float, re.search(rf"^    {name} +(\S+), (\S+)$", log, re.M).groups()))
             for name in ("messages", "bytes", "to ranks") if "What a rank sent" in log}
    return found or dict.fromkeys(("messages", "bytes", "to ranks"), (0.0, 0.0))


def run(column, ranks, steps, kernel):
    """What was sent, and milliseconds of the exchange and of all per gas step, by the clock."""
    case = make(column, ranks, steps, kernel)
    log = case.solve(ranks=ranks)
    lines = exchange_lines(log)
    assert len(lines) == steps, len(lines)
    made = sum(map(int, re.findall(r"Created (\d+) atoms", (case.folder / "log.lammps").read_text())))
    assert made == SPHERES * ranks, made
    seconds = [1000 * float(re.search(rf"^    {row} +(\S+) s", log, re.M)[1]) / steps for row in ("exchange", "all")]
    return sent(log), seconds, max(max(line["imbalance"], line["volume"]) for line in lines)


def most_messages(kernel, steps):
    """That a rank sends in a gas step, the mean of a short run of so many, from its neighbours alone."""
    return NEIGHBOURS * (FORWARD[kernel] + BACK + KEPT / steps)


def most_ranks():
    """To which it sends them."""
    return 2 * NEIGHBOURS
