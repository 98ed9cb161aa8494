# SPDX-License-Identifier: BSD-3-Clause
"""A vessel about an axis in three dimensions, drawn by VTK: the half behind a plane through the axis, on its left the
spheres by their speed, on its right the gas by a slice."""

import functools
from dataclasses import dataclass, field

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from cohesion_studies import vtk_screen
from cohesion_studies.drawing import pyplot
from cohesion_studies.foam_results import read_cloud

MAPS = {"spheres": "turbo", "gas": "YlGnBu"}  # of matplotlib
RIGHT = np.array([1, 0, 0])
AWAY = {"y": np.array([0, 0, -1]), "z": np.array([0, 1, 0])}  # from who looks, by the axis that points upwards
TURN = {"y": 0, "z": -90}  # about x, to y upwards [degrees]
WALL = 0.25  # its opacity


@dataclass
class Section:
    """`wall`: STL file of the vessel's side; `up`: its axis, y or z, through the origin; `radius` of the spheres and
    `height` shown [m]; `speeds` of `spheres` and `gas` at which the colours end [m/s]; `size` of a picture [pixels]."""

    wall: str
    up: str
    radius: float
    height: float
    speeds: dict
    size: tuple
    away: np.ndarray = field(init=False)

    def __post_init__(self):
        self.away = AWAY[self.up]

    def images(self, case, folders):
        """Pictures of written times, {time: folder}, as vtk_screen.images() gives them."""
        middle = 0, self.height / 2, 0
        far = 5 * self.height
        position = -0.11 * far, self.height / 2 + 0.3 * far, far  # from above and a little from the left

        def drawn(vtk, time):
            actors = self.vessel(vtk), self.spheres(vtk, folders[time]), self.gas(vtk, case, time)
            for actor in actors:
                actor.RotateX(TURN[self.up])
            return actors, middle, position, 0.54 * self.height

        return vtk_screen.images(self.size, [functools.partial(drawn, time=time) for time in folders])

    def colour_bars(self, figure, axes):
        """Beside the `axes` that show the pictures."""
        for name, fastest in self.speeds.items():
            scale = ScalarMappable(Normalize(0, fastest), MAPS[name])
            figure.colorbar(scale, ax=axes, shrink=0.6).set_label(f"speed of {name} [m/s]", fontsize=8)

    def spheres(self, vtk, folder):
        """Of a written time, those whose centres are left of the middle and behind the plane."""
        from vtk.util.numpy_support import numpy_to_vtk
        places, velocities = read_cloud(folder)
        shown = (places @ RIGHT < 0) & (places @ self.away > 0)
        points, data = vtk.vtkPoints(), vtk.vtkPolyData()
        points.SetData(numpy_to_vtk(places[shown], deep=True))
        data.SetPoints(points)
        speed = numpy_to_vtk(np.linalg.norm(velocities[shown], axis=1), deep=True)
        speed.SetName("speed")
        data.GetPointData().AddArray(speed)
        ball = vtk.vtkSphereSource()
        ball.SetRadius(self.radius)
        ball.SetThetaResolution(16)
        ball.SetPhiResolution(12)
        glyph = vtk.vtkGlyph3D()
        glyph.SetInputData(data)
        glyph.SetSourceConnection(ball.GetOutputPort())
        glyph.SetScaleModeToDataScalingOff()
        return self.speed_actor(vtk, glyph, "spheres", "speed")

    def gas(self, vtk, case, time):
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
        plane.SetNormal(*self.away)
        plane.SetOrigin(*(1e-6 * self.away))  # not along faces of cells
        cut.SetCutFunction(plane)
        cut.SetInputData(reader.GetOutput().GetBlock(0))
        speed = vtk.vtkArrayCalculator()
        speed.SetInputConnection(cut.GetOutputPort())
        speed.AddVectorArrayName("U")
        speed.SetFunction("mag(U)")
        speed.SetResultArrayName("speed")
        return self.speed_actor(vtk, self.below_top(vtk, clipped(vtk, speed, RIGHT, (0, 0, 0))), "gas", "speed")

    def vessel(self, vtk):
        """The wall of the spheres, behind the plane."""
        reader = vtk.vtkSTLReader()
        reader.SetFileName(str(self.wall))
        half = self.below_top(vtk, clipped(vtk, reader, self.away, (0, 0, 0)))
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(half.GetOutputPort())
        mapper.ScalarVisibilityOff()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.35, 0.45, 0.55)
        actor.GetProperty().SetOpacity(WALL)
        actor.GetProperty().EdgeVisibilityOn()
        actor.GetProperty().SetEdgeColor(0.6, 0.65, 0.7)
        return actor

    def below_top(self, vtk, source):
        """What is shown of a source's surfaces."""
        top = self.height * np.array([self.up == axis for axis in "xyz"])
        return clipped(vtk, source, -top, top)

    def speed_actor(self, vtk, source, name, array):
        """What `source` gives, coloured by the numbers `array` of its points as the speeds of `name`."""
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        mapper.SetLookupTable(colours(vtk, MAPS[name], self.speeds[name]))
        mapper.SetUseLookupTableScalarRange(True)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(array)
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        return actor


def colours(vtk, name, highest):
    """From a map of matplotlib's, over 0 to `highest`."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i, rgba in enumerate(pyplot.get_cmap(name)(np.linspace(0, 1, 256))):
        table.SetTableValue(i, *rgba)
    table.SetRange(0, highest)
    return table


def clipped(vtk, source, normal, point):
    """The part of a source's surfaces on the side of the plane through `point` to which `normal` points."""
    plane, clip = vtk.vtkPlane(), vtk.vtkClipPolyData()
    plane.SetNormal(*normal)
    plane.SetOrigin(*point)
    clip.SetClipFunction(plane)
    clip.SetInputConnection(source.GetOutputPort())
    return clip
