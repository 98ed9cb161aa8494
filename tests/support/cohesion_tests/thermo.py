# SPDX-License-Identifier: BSD-3-Clause
"""What tests want of the thermo output of a run of LAMMPS or LIGGGHTS."""
import math
import re

import numpy

from cohesion_studies import thermo


def thermo_lines(output, run=-1):
    """Names of the columns of a run's thermo output, the last one's unless said otherwise, and its lines of numbers."""
    return thermo.runs(output)[run]


def thermo_end(output):
    """Last line of the last run's, by column name."""
    names, lines = thermo_lines(output)
    return dict(zip(names, lines[-1]))


def thermo_columns(output):
    """The last run's columns by name, as arrays."""
    names, lines = thermo_lines(output)
    return dict(zip(names, numpy.array(lines).T))


def loop_seconds(output, run=-1):
    """That a run, the last one unless said otherwise, took by the clock [s]."""
    return float(re.findall(r"Loop time of (\S+)", output)[run])


def processor_seconds(output, run=-1):
    """That it took of a processor [s]; nan in LIGGGHTS, which reports only the time by the clock."""
    percent = re.findall(r"([\d.]+)% CPU", output)
    return loop_seconds(output, run) * float(percent[run]) / 100 if percent else math.nan


def shown_seconds(seconds, width, digits):
    """For a column of a table; '-' where it is not known."""
    return f"{'-':>{width}s}" if math.isnan(seconds) else f"{seconds:{width}.{digits}f}"
