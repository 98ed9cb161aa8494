# SPDX-License-Identifier: BSD-3-Clause
"""Pictures by VTK without a screen: Debian's draws on an X server alone."""

import contextlib
import fcntl
import importlib.util
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from cohesion_studies.job_pool import RunError, dies_with_us


def require():
    """Raises RunError where VTK, or the X server that it draws on, is missing."""
    for there, what in ((importlib.util.find_spec("vtk"), "python3-vtk9"), (shutil.which("Xvfb"), "xvfb")):
        if not there:
            raise RunError(f"the picture needs Debian's package {what}, which scripts/setup installs")


@contextlib.contextmanager
def one_at_a_time():
    """Waits for the screens of other programs: an X server that ends removes the socket of its number, also where the
    next one has taken that number meanwhile."""
    with open(Path(tempfile.gettempdir()) / f"cohesion-screen-{os.getuid()}", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@contextlib.contextmanager
def screen():
    """An X server without a screen: Debian's VTK draws on no other."""
    reader, writer = os.pipe()
    # hwloc, and with it MPI, looks at the first ten as a program starts, and dies with one that ends just then.
    own = 10 + os.getpid() % 50000
    before = os.environ.get("DISPLAY")
    server = subprocess.Popen(
        dies_with_us(["Xvfb", f":{own}", "-displayfd", str(writer), "-screen", "0", "640x480x24", "-nolisten", "tcp"]),
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


def images(size, scenes):
    """Pictures of `size` pixels, arrays (up to down, across, 3). `scenes`: of each a function scene(vtk) that gives its
    actors; and of the camera, which sees without perspective, where it looks, where it is and half the height that it
    shows [m]."""
    require()
    import vtk  # takes a second
    with one_at_a_time(), screen():
        window = vtk.vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.SetMultiSamples(8)
        window.SetSize(*size)
        try:
            return [image(vtk, window, *scene(vtk)) for scene in scenes]
        finally:
            window.Finalize()  # before its server ends


def image(vtk, window, actors, focus, position, half):
    from vtk.util.numpy_support import vtk_to_numpy
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*position)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(half)
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
