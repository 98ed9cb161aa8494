# SPDX-License-Identifier: BSD-3-Clause
"""The bed in three dimensions, drawn by VTK: the half behind the plane z = 0, on its left the spheres by their speed,
on its right the gas by a slice."""

import functools

import numpy as np

from cohesion_studies import vtk_screen
from cohesion_studies.drawing import pyplot
from cohesion_studies.foam_results import read_cloud

SPEEDS = {"spheres": 1.5, "gas": 20.0}  # where the colours end [m/s]
MAPS = {"spheres": "turbo", "gas": "YlGnBu"}  # of matplotlib
SIZE = 460, 800  # of a picture [pixels]
WALL = 0.25  # its opacity


def colours(vtk, name):
    """From a map of matplotlib's, over the speeds of `name`."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, rgba in enumerate(pyplot.get_cmap(MAPS[name])(np.linspace(0, 1, 256))):
        table.SetTableValue(i, *rgba)
    table.SetRange(0, SPEEDS[name])
    return table


def speed_actor(vtk, source, name, array):
    """What `source` gives, coloured by the numbers `array` of its points."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.SetLookupTable(colours(vtk, name))
    mapper.SetUseLookupTableScalarRange(True)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(array)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def spheres(vtk, folder, radius):
    """Of a written time, those whose centres are left of the middle and behind z = 0."""
    from vtk.util.numpy_support import numpy_to_vtk
    places, velocities = read_cloud(folder)
    shown = (places[:, 0] < 0) & (places[:, 2] < 0)
    points, data = vtk.vtkPoints(), vtk.vtkPolyData()
    points.SetData(numpy_to_vtk(places[shown], deep=True))
    data.SetPoints(points)
    speed = numpy_to_vtk(np.linalg.norm(velocities[shown], axis=1), deep=True)
    speed.SetName("speed")
    data.GetPointData().AddArray(speed)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(16)
    ball.SetPhiResolution(12)
    glyph = vtk.vtkGlyph3D()
    glyph.SetInputData(data)
    glyph.SetSourceConnection(ball.GetOutputPort())
    glyph.SetScaleModeToDataScalingOff()
    return speed_actor(vtk, glyph, "spheres", "speed")


def clipped(vtk, source, *normals):
    """The part of a source's surfaces that planes through the origin leave on the side of their normals."""
    for normal in normals:
        plane, clip = vtk.vtkPlane(), vtk.vtkClipPolyData()
        plane.SetNormal(*normal)
        clip.SetClipFunction(plane)
        clip.SetInputConnection(source.GetOutputPort())
        source = clip
    return source


def gas(vtk, case, time):
    """The right half of a slice through the axis, by the gas's speed."""
    reader = vtk.vtkOpenFOAMReader()
    reader.SetFileName(str(case / "case.foam"))
    reader.CreateCellToPointOn()
    reader.ReadZonesOff()
    reader.UpdateInformation()
    reader.SetTimeValue(time)
    reader.DisableAllCellArrays()
    reader.SetCellArrayStatus("U", 1)
    reader.DisableAllPatchArrays()
    reader.SetPatchArrayStatus("internalMesh", 1)
    reader.Update()
    plane, cut = vtk.vtkPlane(), vtk.vtkCutter()
    plane.SetNormal(0, 0, 1)
    plane.SetOrigin(0, 0, -1e-6)  # not along faces of cells
    cut.SetCutFunction(plane)
    cut.SetInputData(reader.GetOutput().GetBlock(0))
    speed = vtk.vtkArrayCalculator()
    speed.SetInputConnection(cut.GetOutputPort())
    speed.AddVectorArrayName("U")
    speed.SetFunction("mag(U)")
    speed.SetResultArrayName("speed")
    return speed_actor(vtk, clipped(vtk, speed, (1, 0, 0)), "gas", "speed")


def vessel(vtk, case):
    """The mesh wall of the spheres, behind z = 0."""
    reader = vtk.vtkSTLReader()
    reader.SetFileName(str(case / "wall.stl"))
    half, mapper = clipped(vtk, reader, (0, 0, -1)), vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(half.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.35, 0.45, 0.55)
    actor.GetProperty().SetOpacity(WALL)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.6, 0.65, 0.7)
    return actor


def images(case, folders, radius, height):
    """Pictures of written times, {time: folder}, as vtk_screen.images() gives them; radius of the spheres and height
    shown [m]."""
    middle = 0, height / 2, 0
    position = -0.35, height / 2 + 0.9, 3  # from above and a little from the left

    def drawn(vtk, time):
        actors = vessel(vtk, case), spheres(vtk, folders[time], radius), gas(vtk, case, time)
        return actors, middle, position, 0.54 * height

    return vtk_screen.images(SIZE, [functools.partial(drawn, time=time) for time in folders])
