# SPDX-License-Identifier: BSD-3-Clause
"""Runs of pair_style hard/squarewell that end, are refused, or are compared with the reference: what the tests of
its extremes share."""
import numpy

from cohesion_tests import lammps as engine, refusals
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.refusals import assert_refused

BOX = 3 * [(0.0, 20.0)]


def follow(atoms, pair, dt, steps, box=BOX, style="record events.txt", **options):
    """Path, events, thermo columns, output."""
    with engine.temporary_folder() as folder:
        engine.write_spheres(folder, atoms, box, max(atom["type"] for atom in atoms))
        path, table, output = hard.run(folder, pair, dt, steps, style=style, **options)
        return path, hard.recorded(folder) if "record" in style else [], table, output


def refused(case, atoms, pair, dt=0.01, steps=10, box=BOX, **options):
    """The output, LAMMPS' sentence among it; ends with an error."""
    with engine.temporary_folder() as folder:
        engine.write_spheres(folder, atoms, box, 1)
        code, output = hard.start(folder, pair, dt, steps, **options)
    assert_refused(case, code, output, begun=True)
    return refusals.errors(output)


def like_reference(case, atoms, pair, exact, dt, steps, tolerance, **options):
    """Events and ends; gives the table."""
    exact.run(dt * steps)
    path, events, table, _ = follow(atoms, pair, dt, steps, **options)
    case.assertEqual([event.kind.replace("wall_", "") for event in events],
                     [event.kind for event in exact.events])
    numpy.testing.assert_allclose(hard.times(events, dt), [event.time for event in exact.events],
                                  rtol=0, atol=tolerance)
    apart = exact.apart(path[-1, :, 1:4] - exact.place(dt * steps))
    numpy.testing.assert_allclose(apart, 0, rtol=0, atol=tolerance)
    numpy.testing.assert_allclose(path[-1, :, 4:7], exact.v, rtol=0, atol=tolerance)
    return table
