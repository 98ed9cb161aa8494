# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the reactors: the bubbles of each in three dimensions with the mean circulation of the emulsion, and
the hold-up against time."""

import functools

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

import analyse
from cohesion_studies import vtk_screen
from cohesion_studies.drawing import pyplot, save
from cohesion_studies.vtk_spheres import edges, spheres

SIZE = 330, 760  # of a view [pixels]
FASTEST = 1.6  # where the colours of the velocity end [m/s]
BUBBLE = 0.75, 0.85, 0.95


def bubbles(vtk, reactor):
    """Actors of the bubbles, of each size one."""
    places, radii = reactor.bubbles()
    actors = []
    for radius in np.unique(np.round(radii, 3)):
        # z, which is up, becomes y for the camera.
        shown = places[np.round(radii, 3) == radius][:, [0, 2, 1]] * [1, 1, -1]
        actor = spheres(vtk, shown, radius, BUBBLE)
        actor.GetProperty().SetOpacity(0.35)
        actors.append(actor)
    return actors


def arrows(vtk, reactor):
    """The mean velocity of the emulsion in the plane y = width/2, every other row."""
    from vtk.util.numpy_support import numpy_to_vtk
    velocity, _ = reactor.means()
    n, width = reactor.across, reactor.is_of["width"]
    plane = velocity[:, n // 2 - 1: n // 2 + 1].mean(axis=1)[::2]
    x = (np.arange(n) + 0.5) * width / n
    z = (np.arange(reactor.up)[::2] + 0.5) * reactor.is_of["height"] / reactor.up
    grid = np.array([(a, b, -width / 2) for b in z for a in x])
    vectors = plane[:, :, [0, 2, 1]].reshape(-1, 3) * [1, 1, 0]
    points, data, source = vtk.vtkPoints(), vtk.vtkPolyData(), vtk.vtkArrowSource()
    points.SetData(numpy_to_vtk(grid, deep=True))
    data.SetPoints(points)
    for name, values in (("U", vectors), ("up", vectors[:, 1].copy())):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    data.GetPointData().SetActiveVectors("U")
    glyph, mapper, actor, table = (vtk.vtkGlyph3D(), vtk.vtkPolyDataMapper(), vtk.vtkActor(), vtk.vtkLookupTable())
    glyph.SetInputData(data)
    glyph.SetSourceConnection(source.GetOutputPort())
    glyph.SetVectorModeToUseVector()
    glyph.SetScaleModeToScaleByVector()
    glyph.SetScaleFactor(0.25)
    table.SetNumberOfTableValues(256)
    for i, rgba in enumerate(pyplot.get_cmap("coolwarm")(np.linspace(0, 1, 256))):
        table.SetTableValue(i, *rgba)
    table.SetRange(-FASTEST, FASTEST)
    mapper.SetInputConnection(glyph.GetOutputPort())
    mapper.SetLookupTable(table)
    mapper.SetUseLookupTableScalarRange(True)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("up")
    actor.SetMapper(mapper)
    return actor


def images(reactors):
    def drawn(vtk, reactor):
        width, height = reactor.is_of["width"], reactor.is_of["height"]
        box = edges(vtk, (width, height, width))
        box.SetPosition(0, 0, -width)
        middle = np.array([width / 2, height / 2, -width / 2])
        return [*bubbles(vtk, reactor), arrows(vtk, reactor), box], middle, middle + [3, 3, 12], 0.56 * height

    return vtk_screen.images(SIZE, [functools.partial(drawn, reactor=reactor) for reactor in reactors])


def draw(file, folders):
    reactors = [analyse.Reactor(folder) for folder in folders]
    figure = pyplot.figure(figsize=(2.3 * len(reactors) + 4.2, 5.4), constrained_layout=True)
    views, curves = figure.subfigures(1, 2, width_ratios=[2.3 * len(reactors), 4.2])
    places = views.subplots(1, len(reactors), squeeze=False)[0]
    for axes, image, reactor in zip(places, images(reactors), reactors):
        axes.imshow(image)
        axes.set_axis_off()
        axes.set_title(reactor.case.name, fontsize=9)
    views.colorbar(ScalarMappable(Normalize(-FASTEST, FASTEST), "coolwarm"), ax=places, shrink=0.6).set_label(
        "mean upward velocity of the emulsion [m/s]", fontsize=8)
    axes = curves.subplots()
    for reactor in reactors:
        time = reactor.course["step"] / reactor.course["step"][-1] * reactor.is_of["endTime"]
        volume = reactor.is_of["width"] ** 2 * reactor.is_of["height"]
        axes.plot(time, reactor.course["inside_volume"] / volume, linewidth=0.9, label=reactor.case.name)
    axes.set(xlabel="time [s]", ylabel="hold-up of gas [1]", ylim=(0, None))
    axes.legend(frameon=False, fontsize=8)
    save(figure, file, dpi=80)
