# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished bed of two sizes, or of one: where each size is, how well they are mixed, and what carries them.
Lengths in m, pressures in Pa, velocities in m/s."""

import math
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cohesion_studies import ergun
from cohesion_studies.case_entries import entries, gravity
from cohesion_studies.foam_results import function_table, read_cells, read_cloud, written_times

CUBIC = {"none": 0.0, "carmanKozeny": 0.0, "vanDerHoef": 0.064}  # c of docs/openfoam-coupling/drag_closures.md
LAST = 1 / 3  # of a run: over which its end is averaged


@dataclass
class Bed:
    """What a case is of, from its dictionaries."""

    case: Path

    def __post_init__(self):
        self.size = entries(self.case / "constant/bed")
        self.gas = entries(self.case / "constant/transportProperties")
        self.gravity = gravity(self.case)
        self.mixture = re.search(r"^dragMixture\s+(\w+);", (self.case / "constant/couplingProperties").read_text(), re.M)[1]

    def __getattr__(self, name):
        return self.size[name]

    @property
    def cells(self):
        """Across, up and through."""
        return int(self.across), int(self.up), int(self.through)

    @property
    def area(self):
        return self.width * self.thickness

    @property
    def numbers(self):
        return np.array([self.small, self.large])

    @property
    def diameters(self):
        return np.array([self.smallDiameter, self.largeDiameter])

    @property
    def solid(self):
        """Volume of each size."""
        return self.numbers * math.pi / 6 * self.diameters**3

    def moment(self, power):
        """Of the diameters, a sum over the spheres."""
        return float((self.numbers * self.diameters**power).sum())

    @property
    def weight(self):
        """Of the spheres in the gas, per area of the plate [Pa]."""
        return self.solid.sum() * (self.density - self.gas["rho"]) * self.gravity / self.area

    @property
    def sauter(self):
        return self.moment(3) / self.moment(2)

    def drag_of_mixture(self, void_fraction):
        """What the law for mixtures multiplies the pressure drop of the Sauter mean by."""
        spread = self.moment(4) / (self.moment(2) * self.sauter**2)
        return 1 + CUBIC[self.mixture] * void_fraction * spread

    def gradient(self, void_fraction, velocity):
        """Of the pressure, that the closure ergunWenYu has in this mixture; arrays."""
        rho, viscosity = self.gas["rho"], self.gas["rho"] * self.gas["nu"]
        viscous, inertial = ergun.coefficients(void_fraction, self.sauter, rho, viscosity)
        reynolds = rho * velocity * self.sauter / viscosity
        single = 18 * viscosity / self.sauter**2 * (1 + 0.15 * reynolds**0.687)
        return self.drag_of_mixture(void_fraction) * velocity * np.where(
            void_fraction < 0.8, viscous + inertial * velocity, (1 - void_fraction) * single * void_fraction**-4.65)

    def minimum_fluidisation(self, void_fraction):
        """At which that gradient is the weight of the spheres in the gas."""
        weight = (1 - void_fraction) * (self.density - self.gas["rho"]) * self.gravity
        return float(root(lambda velocity: self.gradient(void_fraction, velocity) - weight, 0.0, self.terminal))

    terminal = 100.0  # faster than any sphere here falls


def root(rising, low, high):
    """At which a function that rises is 0, between numbers or arrays, to round-off."""
    low, high = np.broadcast_arrays(low, high)
    for _ in range(60):
        middle = (low + high) / 2
        above = rising(middle) > 0
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    return (low + high) / 2


@dataclass
class Spheres:
    """Of one written time."""

    places: np.ndarray
    large: np.ndarray  # whether each is

    @classmethod
    def read(cls, folder):
        return cls(read_cloud(folder)[0], kinds(folder / "lagrangian/particles/type") == 2)


def kinds(file):
    """Whole numbers of a list, which is written as one where all are equal."""
    text = Path(file).read_text()
    equal = re.search(r"^(\d+)\{(\d+)\}", text, re.M)
    if equal:
        return np.full(int(equal[1]), int(equal[2]))
    return np.array(re.search(r"^\d+\s*\(([^)]*)\)", text, re.M)[1].split(), dtype=int)


def history(bed):
    """Times and Spheres of all that was written."""
    found = sorted(written_times(bed.case).items())
    return np.array([time for time, _ in found]), [Spheres.read(folder) for _, folder in found]


def shares_below(heights, large, volumes):
    """The shares of small and of large spheres in the lower half: below the height that has half of the solid volume
    below it, by centres. `volumes`: of one small and of one large sphere. The sphere in which the half ends counts by
    the part of it that is still in it."""
    order = np.argsort(heights)
    each = np.where(large[order], volumes[1], volumes[0])
    top = np.cumsum(each)
    lower = np.clip((top[-1] / 2 - (top - each)) / each, 0, 1)
    return tuple(float(lower[kind].sum() / kind.sum()) for kind in (~large[order], large[order]))


def segregation(heights, large, share_small):
    """Goldschmidt's: 0 mixed, 1 where all small spheres lie on all large ones. The mean height of the small ones over
    that of the large, S, goes from 1 to (2 - x)/(1 - x) then, x being the small ones' share of the solid volume."""
    ratio = heights[~large].mean() / heights[large].mean()
    most = (2 - share_small) / (1 - share_small)
    return float((ratio - 1) / (most - 1))


def lacey_index(cells, large):
    """Of src/bed/lacey_index.h: 0 segregated, 1 dealt out at random. `cells`: number of the cell of each sphere."""
    counts = np.array([np.bincount(cells[kind], minlength=cells.max() + 1) for kind in (~large, large)], dtype=float)
    in_cell = counts.sum(axis=0)
    used = in_cell > 0
    share = counts.sum(axis=1) / in_cell.sum()
    apart = 1 - (share**2).sum()
    at_random = apart * (used.sum() - 1) / (in_cell.sum() - 1)
    same = (counts[:, used]**2 / in_cell[used]).sum() / in_cell.sum()
    return float((1 - same) / (apart - at_random))


def cells_of(bed, places):
    """Number of the cell of the mesh that each place is in."""
    box = np.array([bed.width, bed.height, bed.thickness])
    index = np.clip((places / box * bed.cells).astype(int), 0, np.array(bed.cells) - 1)
    return np.ravel_multi_index(index.T, bed.cells)


def mixing_history(bed):
    """Times, and for each: segregation, shares of small and large spheres in the lower half, Lacey's index."""
    times, spheres = history(bed)
    volumes = bed.solid / bed.numbers
    share = bed.solid[0] / bed.solid.sum()
    rows = [(segregation(now.places[:, 1], now.large, share), *shares_below(now.places[:, 1], now.large, volumes),
             lacey_index(cells_of(bed, now.places), now.large)) for now in spheres]
    return times, np.array(rows).T


def drop_history(bed):
    """Times, and the pressure drop over the weight of the spheres in the gas."""
    table = np.loadtxt(function_table(bed.case, "drop", "bedPressureDrop.dat"), comments="#", ndmin=2)
    return table[:, 0], table[:, -1]


def force_history(bed):
    """Times, and vertical forces over the weight of the spheres: of the gas, of walls and plate; what momentum gains."""
    table = np.loadtxt(function_table(bed.case, "forces", "forceBudget.dat"), comments="#", ndmin=2)
    weight, drag, pressure, others, gain = table[:, 3::3].T
    return table[:, 0], np.array([drag + pressure, others, gain]) / -weight


def rest_height(bed):
    """Twice the mean height when the gas begins."""
    return float(np.loadtxt(function_table(bed.case, "height", "bedHeight.dat"), comments="#", ndmin=2)[0, 1])


def resting_void_fraction(bed):
    """Of the bed when the gas begins: of one density and that height."""
    return float(1 - bed.solid.sum() / (bed.area * rest_height(bed)))


def void_fraction(bed, folder):
    """Of the cells in a written time, (through, up, across)."""
    return read_cells(folder / "voidFraction", math.prod(bed.cells)).reshape(bed.cells[::-1])


def closure_drops(bed, void, velocity):
    """The pressure drop over cells that the closure has, between two limits: (gas that goes sidewards freely, so that
    all cells of a layer have one gradient; gas that goes straight up). What is real lies between: resistances that rise
    with the flow are a network, in which less is wasted the more ways there are."""
    straight = bed.gradient(void, velocity).mean(axis=(0, 2))

    def flow(gradient):
        """Mean velocity in each layer."""
        gradient = gradient[None, :, None]
        # A cell without a sphere lets all pass: the layer has no gradient then.
        return root(lambda v: bed.gradient(void, v) - gradient, np.zeros_like(void), np.full_like(void, bed.terminal)
                    ).mean(axis=(0, 2))

    free = root(lambda gradient: flow(gradient) - velocity, np.zeros_like(straight), straight)
    layer = bed.height / bed.up
    return float(free.sum() * layer), float(straight.sum() * layer)


def momentum(bed, folder):
    """What the gas of a written time loses of its momentum on its way [Pa]: it comes in between the spheres of the
    lowest cells and goes out without any. The pressure drop is less than what the gas puts on the spheres by that."""
    lowest = void_fraction(bed, folder)[:, 0, :]
    return float(bed.gas["rho"] * bed.velocity**2 * ((1 / lowest).mean() - 1))


def seconds_per_second(bed):
    """By the clock, of one simulated second."""
    log = (bed.case / "log.cohesiveBedFoam").read_text()
    time, seconds = re.findall(r"^Time = (\S+)  \(\S+ %, (\S+) s elapsed", log, re.M)[-1]
    return float(seconds) / float(time)


def packed_figures(case):
    """Of a bed of one size that the gas does not lift."""
    bed = Bed(Path(case))
    void = resting_void_fraction(bed)
    folder = max(written_times(bed.case).items())[1]
    drop = drop_history(bed)[1][-1] * bed.weight + momentum(bed, folder)
    free, straight = closure_drops(bed, void_fraction(bed, folder), bed.velocity)
    return {"resting_void_fraction": void, "U_mf": bed.minimum_fluidisation(void),
            "drop_over_free_flow": drop / free, "drop_over_straight_flow": drop / straight}


def figures(case):
    """Those of a bed of two sizes that are one number: means over the last third of the run."""
    bed = Bed(Path(case))
    times, (apart, small, large, lacey) = mixing_history(bed)
    last = times > (1 - LAST) * times[-1]
    when, drop = drop_history(bed)
    at, (gas, walls, gain) = force_history(bed)
    end, of_forces = when > (1 - LAST) * when[-1], at > (1 - LAST) * at[-1]
    void = resting_void_fraction(bed)
    brought = np.mean([momentum(bed, folder) for time, folder in written_times(bed.case).items()
                       if time > (1 - LAST) * times[-1]]) / bed.weight
    return {"segregation_at_start": float(apart[0]), "segregation": float(apart[last].mean()),
            "small_in_lower_half": float(small[last].mean()), "large_in_lower_half": float(large[last].mean()),
            "lacey_at_start": float(lacey[0]), "lacey": float(lacey[last].mean()),
            "drop_over_weight": float(drop[end].mean()), "drop_deviation": float(drop[end].std()),
            "gas_over_weight": float(gas[of_forces].mean()), "walls_over_weight": float(walls[of_forces].mean()),
            "gain_over_weight": float(gain[of_forces].mean()), "momentum_over_weight": float(brought),
            "drop_unexplained": float(drop[end].mean() - gas[of_forces].mean() + brought),
            "resting_void_fraction": void, "U_mf": bed.minimum_fluidisation(void),
            "seconds_per_second": seconds_per_second(bed)}
