# SPDX-License-Identifier: BSD-3-Clause
"""Spheres of a box in three dimensions, drawn by VTK: pictures as arrays, for matplotlib."""

import functools

import numpy as np

from cohesion_studies import vtk_screen


def spheres(vtk, places, radius, colour):
    """An actor: spheres of one radius [m] and colour, red, green and blue up to 1."""
    from vtk.util.numpy_support import numpy_to_vtk
    points, data = vtk.vtkPoints(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(places), deep=True))
    data.SetPoints(points)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(20)
    ball.SetPhiResolution(14)
    glyph, mapper, actor = vtk.vtkGlyph3D(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
    glyph.SetInputData(data)
    glyph.SetSourceConnection(ball.GetOutputPort())
    glyph.SetScaleModeToDataScalingOff()
    mapper.SetInputConnection(glyph.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    return actor


def edges(vtk, box):
    """An actor: those of a box from 0 to `box` [m]."""
    cube, outline, mapper, actor = vtk.vtkCubeSource(), vtk.vtkOutlineFilter(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
    cube.SetBounds(*(bound for size in box for bound in (0, size)))
    outline.SetInputConnection(cube.GetOutputPort())
    mapper.SetInputConnection(outline.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.4, 0.4, 0.4)
    return actor


def images(scenes, box, size):
    """Pictures of `scenes`, each a list of (places, radius, colour), in a box from 0 to `box` [m], y upwards; `size` in
    pixels. As vtk_screen.images() gives them."""
    middle, far = np.array(box) / 2, 10 * max(box)
    position = middle + far * np.array([0.35, 0.3, 1.0])  # from the right and a little above

    def drawn(vtk, scene):
        return [*(spheres(vtk, *group) for group in scene), edges(vtk, box)], middle, position, 0.56 * box[1]

    return vtk_screen.images(size, [functools.partial(drawn, scene=scene) for scene in scenes])
