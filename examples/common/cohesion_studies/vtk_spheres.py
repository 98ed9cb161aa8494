# SPDX-License-Identifier: BSD-3-Clause
"""Spheres of a box in three dimensions, drawn by VTK: pictures as arrays, for matplotlib."""

import contextlib
import importlib.util
import os
import shutil
import subprocess

import numpy as np

from cohesion_studies.job_pool import RunError, dies_with_us


def require():
    """Raises RunError where VTK, or the X server that it draws on, is missing."""
    for there, what in ((importlib.util.find_spec("vtk"), "python3-vtk9"), (shutil.which("Xvfb"), "xvfb")):
        if not there:
            raise RunError(f"the picture needs Debian's package {what}, which scripts/setup installs")


@contextlib.contextmanager
def screen():
    """An X server without a screen: Debian's VTK draws on no other."""
    reader, writer = os.pipe()
    before = os.environ.get("DISPLAY")
    server = subprocess.Popen(
        dies_with_us(["Xvfb", "-displayfd", str(writer), "-screen", "0", "640x480x24", "-nolisten", "tcp"]),
        pass_fds=[writer], stderr=subprocess.DEVNULL)
    os.close(writer)
    try:
        with open(reader) as told:
            number = told.readline().strip()
        if not number:
            raise RunError("Xvfb, on which the picture is drawn, did not start")
        os.environ["DISPLAY"] = f":{number}"
        yield
    finally:
        server.terminate()
        server.wait()
        os.environ.pop("DISPLAY", None)
        if before is not None:
            os.environ["DISPLAY"] = before


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
