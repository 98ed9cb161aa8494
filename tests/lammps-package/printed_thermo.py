# SPDX-License-Identifier: BSD-3-Clause
"""Reads the thermo output of LAMMPS or LIGGGHTS."""


def thermo_lines(output):
    """Names of the columns of the last run's thermo output, and its lines of numbers. What another rank printed comes
    between them at any place."""
    lines = output.splitlines()
    header = max(i for i, line in enumerate(lines) if line.split()[:1] == ["Step"])
    names, values = lines[header].split(), []
    for line in lines[header + 1:]:
        words = line.split()
        if words[:2] == ["Loop", "time"]:
            break
        if len(words) != len(names):
            continue
        try:
            values.append([float(word) for word in words])
        except ValueError:
            continue
    return names, values


def thermo(output):
    """Last line of thermo output, by column name."""
    names, values = thermo_lines(output)
    return dict(zip(names, values[-1]))
