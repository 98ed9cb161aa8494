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
# What a gas step of form A sends in a pair of ranks. From the rank that has particles to the one in whose cells they
# are: how many queries, the queries, which of them are parts (particleExchange::locate); the sum of the shares, of
# kernels that span cells (setWeights); volume (particleVoidFraction), coefficient, source and transmitted volume of
# the particles (gasParticleCoupling::setSources).
FORWARD = {"particleCentre": 7, "dividedVolume": 8, "sphereOverlap": 8}
# Back: the replies (locate); void fraction and velocity for the drag (gasAtParticles::set); velocity, pressure
# gradient and transmitted gradient at the end of the step (gasParticleCoupling::advanceParticles).
BACK = 6


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
    # With this file handler the solver keeps no states (keptState), whose messages are not those of every gas step.
    log = case.solve("-fileHandler", "masterUncollated", ranks=ranks)
    lines = exchange_lines(log)
    assert len(lines) == steps, len(lines)
    made = sum(map(int, re.findall(r"Created (\d+) atoms", (case.folder / "log.lammps").read_text())))
    assert made == SPHERES * ranks, made
    seconds = [1000 * float(re.search(rf"^    {row} +(\S+) s", log, re.M)[1]) / steps for row in ("exchange", "all")]
    return sent(log), seconds, max(max(line["imbalance"], line["volume"]) for line in lines)


def pairs(ranks):
    """(rank that has particles, other rank in whose cells they are). LAMMPS numbers its ranks along y first, the gas
    along x."""
    along_x, along_y = grid(ranks)
    # From its place plus SHIFT to the next one's: two places of the gas, at the far side one
    x, y = ([(k, cell) for k in range(n) for cell in (k, k + 1) if cell < n] for n in (along_x, along_y))
    both = [(kx * along_y + ky, x_cell + along_x * y_cell) for kx, x_cell in x for ky, y_cell in y]
    return [(particles, cells) for particles, cells in both if particles != cells]


def expected(ranks, kernel):
    """As sent(), without the bytes: what follows from the pairs of ranks alone."""
    messages, to = [0] * ranks, [set() for _ in range(ranks)]
    for particles, cells in pairs(ranks):
        messages[particles] += FORWARD[kernel]
        messages[cells] += BACK
        to[particles].add(cells)
        to[cells].add(particles)
    values = {"messages": messages, "to ranks": [len(others) for others in to]}
    return {name: (sum(one) / ranks, max(one)) for name, one in values.items()}


def differing(counts, ranks, kernel):
    """Names of the counts that are not those expected. Figures of the log have twelve digits at most."""
    return [name for name, pair in expected(ranks, kernel).items()
            if any(abs(found - wanted) > 1e-6 for found, wanted in zip(counts[name], pair))]
