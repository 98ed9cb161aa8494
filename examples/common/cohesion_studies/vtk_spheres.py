# SPDX-License-Identifier: BSD-3-Clause
"""Spheres of a box in three dimensions, drawn by VTK: pictures as arrays, for matplotlib."""

import numpy as np

from cohesion_studies.vtk_screen import require, screen


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
    pixels. Arrays (up to down, across, 3)."""
    require()
    import vtk  # takes a second
    with screen():
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(8)
        window.SetSize(*size)
        try:
            return [image(vtk, window, [*(spheres(vtk, *group) for group in scene), edges(vtk, box)], box)
                    for scene in scenes]
        finally:
            window.Finalize()  # before its server ends


def image(vtk, window, actors, box):
    from vtk.util.numpy_support import vtk_to_numpy
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    middle, far = np.array(box) / 2, 10 * max(box)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*middle)
    camera.SetPosition(*(middle + far * np.array([0.35, 0.3, 1.0])))  # from the right and a little above
    camera.ParallelProjectionOn()
    camera.SetParallelScale(0.56 * box[1])
    renderer.ResetCameraClippingRange()
    window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    window.RemoveRenderer(renderer)
    across, up, _ = grab.GetOutput().GetDimensions()
    return vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars()).reshape(up, across, 3)[::-1].copy()
