# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished run of in.cooling: cooling, agglomerates, modes of shear. Diameter, mass and the temperature at
the start are 1."""

from pathlib import Path

import numpy as np

from theory import Gas

LARGE = 0.1  # of all spheres: from here on an agglomerate is no longer one of many


def cooling(log):
    """Dict of the columns of the run, a value for each interval, after that of the start."""
    lines = [line.split()[1:] for line in log.splitlines() if line.startswith("cooling ")]
    names = lines[0]
    start = {name: 0.0 for name in names} | {"temperature": 1.0}
    rows = [[start[name] for name in names]] + [[float(word) for word in row] for row in lines[1:]]
    return dict(zip(names, np.array(rows).T))


def exponent(found):
    """alpha and tau of T = (1 + t/tau)^-alpha, both free, by least squares of ln T. For a given tau alpha is linear:
    only tau is searched for."""
    t, log_T = found["time"][1:], np.log(found["temperature"][1:])

    def best(tau):
        x = np.log1p(t / tau)
        alpha = -x @ log_T / (x @ x)
        return float(np.sum((log_T + alpha * x)**2)), alpha

    low, high = np.log(t[0] / 10), np.log(10 * t[-1])
    for _ in range(6):  # each search is ten times as fine as the one before
        grid = np.linspace(low, high, 41)
        at = min(range(41), key=lambda i: best(np.exp(grid[i]))[0])
        low, high = grid[max(at - 2, 0)], grid[min(at + 2, 40)]
    tau = float(np.exp(grid[at]))
    return best(tau)[1], tau


def collisions_and_loss(found, gas, count):
    """Collisions of a sphere per time, and energy that one takes, over those of `gas` at the temperatures of the run:
    s = 1/sqrt(T) is a straight line of t in each interval."""
    s, t = found["temperature"]**-0.5, found["time"]
    passed = np.sum(np.diff(t) * np.diff(np.log(s)) / np.diff(s))  # of sqrt(T) dt
    each = 2 * found["collisions"][-1] / count
    frequency = each / passed / gas.frequency
    # Free motion of all spheres has 3 (count - 1) T/2: their momentum is none.
    lost = 3 * np.log(s[-1] / s[0]) * (count - 1) / count / (each / 2)
    return float(frequency), float(lost / (3 * gas.zeta / gas.frequency))


def shear_energy(folder, side):
    """Mean energy of the longest modes of shear, over that of as many parts of the motion of single spheres."""
    rows = np.loadtxt(Path(folder) / "spheres-end.txt", skiprows=9)
    places, speeds = rows[:, 1:4], rows[:, 5:8]
    energies = []
    for direction in range(3):
        waves = np.exp(2j * np.pi / side * places[:, direction])
        for across in {0, 1, 2} - {direction}:
            energies.append(abs(speeds[:, across] @ waves)**2 / len(rows))
    return float(np.mean(energies) / np.mean(speeds**2))


def gathered(found):
    """Row of the interval in which the largest agglomerate passes LARGE of all spheres; None when it does not."""
    large = np.flatnonzero(found["largest"] > LARGE)
    return int(large[0]) if len(large) else None


def figures(folder, log, settings):
    """Those of one run, numbers only; nan where there is none."""
    found, gas = cooling(log), Gas(settings["phi"], settings["e"])
    count, D = settings["side"]**3, settings["D"]
    t, T = found["time"], found["temperature"]
    result = {"cooled": float(T[-1]), "rate": float((T[-1]**-0.5 - 1) / t[-1] * gas.tau)}
    result["exponent"], tau = exponent(found)
    result["tau_of_exponent"] = tau / gas.tau
    result["frequency"], result["loss"] = collisions_and_loss(found, gas, count)
    result["collisions_each"] = 2 * float(found["collisions"][-1]) / count
    result["shear_energy"] = shear_energy(folder, gas.side(count))
    at = gathered(found)
    result["gathered_at"] = float("nan") if at is None else float(np.sqrt(T[at] * T[at - 1]) / D)
    result["size_end"], result["largest_end"] = float(found["size"][-1]), float(found["largest"][-1])
    result["elastic"] = float(found["elastic"][-1])
    return result
