# SPDX-License-Identifier: BSD-3-Clause
"""Prints the figures of one finished case of the fluidised bed, those that are one number.

    figures.py CASE

The y axis points up, p is 0 at the top of the mesh, its bottom is at y = 0, the gas has a constant density, the mesh is
of blockMesh, and fields are in ASCII. The run starts at 0 and was not continued. Values are plain numbers, without
macros. Next to log.cohesiveBedFoam the case has:

system/controlDict   volFieldValue lowestPressure: volAverage of p over the lowest row of cells; surfaceFieldValue
                     jetVelocity: areaAverage of U over the patch through which the gas enters; function objects mixing,
                     movement and forces
constant/schedule    steps of the superficial velocity: a table of times and vectors; two equal rows are a step, one of
                     them without gas
constant/bed         across and up, cells of the one block of the mesh, row by row from the plate up; jetShare, open
                     share of the plate
constant/transportProperties, constant/g   rho, nu, gravity
constant/couplingProperties                engine and script; dt among variables
the script           variables d and density of all particles
bed.dat              columns step, weight of the particles above the centres of the lowest cells, twice their mean
                     height
walls.dat            columns step, vertical force of plate and side walls on the particles, that of the side walls, and,
                     if the engine has it, that of the plate's attraction; means of all particle steps since the last
                     row
"""

from math import nan

from cohesion_studies import program
from cohesion_studies.bed.figures import evaluate, single
from cohesion_studies.case_entries import EntryError
from cohesion_studies.study_table import aligned, with_deviation


def main():
    case, = program.words(__doc__, 1)
    print(aligned([(name, with_deviation(value, nan, ".6g")) for name, value in single(evaluate(case)).items()]))


if __name__ == "__main__":
    program.run(main, OSError, EntryError)
