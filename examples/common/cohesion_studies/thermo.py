# SPDX-License-Identifier: BSD-3-Clause
"""Reads the thermo output of LAMMPS and LIGGGHTS."""


def number(word):
    """NaN of what is none."""
    try:
        return float(word)
    except ValueError:
        return float("nan")


def printed(output):
    """Of each `run`, in order: names of the columns, and the words of each line. What else was printed between the
    lines, warnings and what other ranks say, is left out."""
    found, names = [], None
    for line in output.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            names = words
            found.append((names, []))
        elif words[:2] == ["Loop", "time"]:
            names = None
        elif names and len(words) == len(names) and words[0].isdigit():
            found[-1][1].append(words)
    return found


def runs(output):
    """The same with the words as numbers."""
    return [(names, [[number(word) for word in words] for words in lines]) for names, lines in printed(output)]
