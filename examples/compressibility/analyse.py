# SPDX-License-Identifier: BSD-3-Clause
"""Reads finished runs of in.gas, in.soft and in.flow: means and their errors from blocks."""

import math

import numpy as np

import theory
from cohesion_studies.lammps_run import tables


def mean(values):
    """And its standard error, of blocks that know nothing of each other."""
    values = np.asarray(values, float)
    return float(values.mean()), float(values.std(ddof=1) / math.sqrt(len(values)))


def noted(found, name, values):
    found[name], found[f"{name}_error"] = mean(values)


def own_temperature(by, warmth, time, count):
    """Of the motion that is left without that of all together, a third of a degree of freedom for each sphere: the fix
    takes the mean over all spheres, the engine over all but one."""
    return np.diff(warmth) / np.diff(time) * (count / (count - 1) if by in ("rescale", "random") else 1)


def hard(log, given):
    """y by the virial and by the number of collisions, power, of in.gas."""
    lines = [line.split()[1:] for line in log.splitlines() if line.startswith("gas ")]
    rows = dict(zip(lines[0], np.array(lines[1:], float).T))
    count = given["count"]
    time = np.diff(rows["time"])
    T = own_temperature(given["by"], rows["temperature_time"], rows["time"], count)
    found = {"phi": given["phi"], "e": given["e"], "D": given["D"], "w": given["w"]}
    y = np.diff(rows["virial"]) / (3 * count * T * time)
    noted(found, "y", y)
    often = 2 * np.diff(rows["collisions"]) / count / time
    noted(found, "y_events", often * np.sqrt(math.pi / T) / 6)
    found["T"] = float(T.mean())
    half = len(y) // 2
    found["drift"] = float((y[half:].mean() - y[:half].mean()) / y.mean())
    found["collisions"] = float(rows["collisions"][-1] * 2 / count)
    lost, put_in = np.ptp(rows["lost"]), np.ptp(rows["given"])
    if given["e"] < 1:
        found["power"] = float((put_in - rows["potential"][-1] + rows["potential"][0]) / lost)
    found["potential"] = float(np.mean(rows["potential"]) / count)
    return found


def soft(log, given):
    """The same of in.soft."""
    rows = tables(log)[-1]
    count = given["count"]
    time = rows["Step"] * given["dt"]
    T = own_temperature(given["by"], rows["f_drive[2]"], time, count)
    found = {"phi": given["phi"], "e": given["e"], "A": given["A"]}
    noted(found, "y", np.diff(rows["v_virial"]) / (3 * count * T * np.diff(time)))
    found["T"] = float(T.mean())
    found["diameter"] = theory.soft_diameter(given["K"])
    if given["e"] < 1:
        stored = rows["c_tally[1]"] + rows["c_tally[3]"] + rows["c_tally[5]"]  # and in motion
        found["power"] = float((np.ptp(rows["f_drive"]) - stored[-1] + stored[0]) / np.ptp(rows["c_tally[6]"]))
        found["power_raw"] = float(np.ptp(rows["f_drive"]) / np.ptp(rows["c_tally[6]"]))
    return found


def flow(log, given):
    """Viscosity of in.flow: by the shear stress where it is sheared; else by how far the stress, summed over time, has
    gone: (V/2 T) d/dt <(int P_xy dt)^2> (Helfand 1960), of the five shears that are one by symmetry."""
    rows = tables(log)[-1]
    count, phi, rate = given["count"], given["phi"], given["rate"]
    volume = math.pi * count / 6 / phi
    time = (rows["Step"] - rows["Step"][0]) * given["dt"]
    kinetic = np.array([rows[f"f_kinetic[{k}]"] for k in range(1, 7)])[:, 1:]
    carried = np.diff([rows[f"c_stress[1][{k}]"] for k in range(1, 7)], axis=1)
    passed = np.diff(time)
    stress = kinetic + carried / volume / passed
    found = {"phi": phi, "rate": rate, "T": float(np.mean(rows["c_flow"]) * count / (count - 1))}
    blocks = 10
    if rate:
        found["followed"] = float(np.mean(rows["c_flow[1]"]) / rate)
        noted(found, "viscosity", [-part.mean() / rate for part in np.array_split(stress[3], blocks)])
        noted(found, "kinetic", [-part.mean() / rate for part in np.array_split(kinetic[3], blocks)])
        noted(found, "y", [part.mean() for part in
                           np.array_split((stress - kinetic)[:3].mean(axis=0) * volume / count, blocks)])
    else:
        shears = np.array([stress[3], stress[4], stress[5], (stress[0] - stress[1]) / 2,
                           (stress[0] + stress[1] - 2 * stress[2]) / math.sqrt(12)]) * passed
        free = 1 / theory.frequency(phi)
        lags = [max(1, round(n * free / passed[0])) for n in (5, 15)]

        def gone(part):
            way = np.concatenate([np.zeros((5, 1)), np.cumsum(part, axis=1)], axis=1)
            first, second = (np.mean((way[:, lag:] - way[:, :-lag])**2) for lag in lags)
            return volume / 2 * (second - first) / ((lags[1] - lags[0]) * passed[0])
        noted(found, "viscosity", [gone(part) for part in np.array_split(shears, blocks, axis=1)])
    found["over_enskog"] = found["viscosity"] / theory.enskog(phi) / math.sqrt(found["T"] if rate else 1.0)
    found["over_enskog_error"] = found["viscosity_error"] / theory.enskog(phi)
    return found
