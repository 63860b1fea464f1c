# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Views, pictures and comparisons for tests that pvbatch runs."""

import contextlib
import itertools
import os
import pathlib
import re
import socket
import subprocess
import tempfile
import time
import unittest

import numpy
import paraview
from paraview import servermanager, simple, smtrace
from paraview.modules.vtkRemotingCore import vtkProcessModule
from paraview.modules.vtkRemotingServerManager import vtkSMUndoStack, vtkSMUndoStackBuilder
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

FILTER = """
<ServerManagerConfiguration><ProxyGroup name="filters">
  <SourceProxy name="{0}" class="{1}">
    <InputProperty name="Input" command="SetInputConnection" />
    {2}
  </SourceProxy>
</ProxyGroup></ServerManagerConfiguration>
"""
PROPERTY = """
<ProxyProperty name="{0}" command="Set{0}"><ProxyListDomain name="proxy_list">
  <Proxy group="relevo_surfaces" name="None" /><Proxy group="relevo_{1}" name="{2}" />
</ProxyListDomain></ProxyProperty>
"""
STYLES = "Adaptive Refinement", "Surface"

# Without the variables that MPI has set for this process; other processes would otherwise join it.
ENVIRONMENT = {
    name: value
    for name, value in os.environ.items()
    if not name.startswith(("OMPI_", "PMIX_"))
    or name.startswith("OMPI_ALLOW")
    or name == "OMPI_MCA_mpi_yield_when_idle"
}


def find_plugin(name):
    """The file of one of ParaView's plugins, or None."""
    prefix = pathlib.Path(paraview.__file__).parents[4]
    return next(map(str, prefix.glob(f"lib*/**/plugins/{name}/{name}.so")), None)


def define_filter(name, of_class, properties):
    """Registers a class of filters on all ranks. Returns a function that creates one. Each property
    is None at first, and may also be the plugin's proxy of this group and name."""
    made = {__name__: None}
    text = "".join(PROPERTY.format(each, *properties[each]) for each in properties)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, f"{name}.xml")
        path.write_text(FILTER.format(name, of_class, text), encoding="utf-8")
        simple.LoadPlugin(str(path), remote=True, ns=made)
    return made[name]


def sphere(**properties):
    return simple.Sphere(ThetaResolution=9, PhiResolution=7, **properties)


def view(size=(300, 200)):
    """A new view that draws on all ranks, however small the data are."""
    result = simple.CreateView("RenderView")
    result.ViewSize = size
    result.RemoteRenderThreshold = 0
    result.OrientationAxesVisibility = 0
    simple.SetActiveView(result)
    return result


def show(source, in_view, representation="Adaptive Refinement", **properties):
    """Shows a source in grey as `representation` with these properties."""
    result = simple.Show(source, in_view)
    result.Representation = representation
    result.ColorArrayName = ["POINTS", ""]
    set_properties(result, properties)
    return result


def set_properties(proxy, properties):
    """Uses the property names of ParaView 5.11, which later versions accept on request."""
    version = paraview.compatibility
    version.major, version.minor = 5, 11
    for name, value in properties.items():
        setattr(proxy, name, value)
    version.major = version.minor = None


def picture(of_view):
    """The picture of a view: rows x columns x 3 unsigned bytes, lowest row first."""
    simple.Render(of_view)
    return pixels(of_view.CaptureWindow(1))


def drawn(view):
    """The latest frame of a view, without a new one."""
    return read_window(view.GetRenderWindow())


def read_window(window):
    """The latest frame of a window of VTK."""
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.ShouldRerenderOff()
    grabber.ReadFrontBufferOff()
    grabber.Update()
    return pixels(grabber.GetOutput())


def pixels(image):
    """Rows x columns x 3 unsigned bytes, lowest row first."""
    columns, rows, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)[..., :3].copy()


def differing(one, other, tolerance=2):
    """Number of pixels that differ by more than `tolerance` of 255 in some component."""
    return int((numpy.abs(one.astype(int) - other).max(axis=2) > tolerance).sum())


def foreground(of_picture):
    """Number of pixels whose colour differs from the lower left corner."""
    return differing(of_picture, numpy.broadcast_to(of_picture[0, 0], of_picture.shape), 0)


def statistic(view, name):
    """A counter of the mapper of the last surface shown."""
    actors = list(view.GetClientSideObject().GetRenderer().GetActors())
    texts = [str(actor.GetMapper()) for actor in actors if actor.GetVisibility()]
    return int(re.findall(rf"\b{name}: (\d+)", "".join(texts))[-1])


def copy_camera(source, target):
    for name in ("CameraPosition", "CameraFocalPoint", "CameraViewUp", "CameraParallelScale"):
        setattr(target, name, getattr(source, name))


def write_heights(path, size=33):
    """A hill in the middle of a 16-bit raster."""
    middle = (size - 1) / 2
    row, column = numpy.mgrid[:size, :size] - middle
    heights = 10 * numpy.clip(1 - numpy.hypot(row, column) / middle, 0, None)
    write_png(path, heights.astype(numpy.uint16))


def write_png(path, values):
    """Rows x columns, or rows x columns x components, lowest row first."""
    image = vtkImageData()
    image.SetDimensions(values.shape[1], values.shape[0], 1)
    components = values.shape[2] if values.ndim > 2 else 1
    scalars = numpy_to_vtk(values.reshape(-1, components), deep=1)
    image.GetPointData().SetScalars(scalars)
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(path)
    writer.Write()


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return pixels(reader.GetOutput())


def leaves(source):
    """The meshes of all ranks."""
    data = servermanager.Fetch(source)
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    iterator = data.NewIterator()
    result = []
    while not iterator.IsDoneWithTraversal():
        result.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return result


def corners(source, names):
    """Triangles x 3 corners x coordinates and point data."""
    results = []
    for mesh in leaves(source):
        data = [mesh.GetPoints().GetData(), *map(mesh.GetPointData().GetArray, names)]
        points = numpy.column_stack([vtk_to_numpy(each) for each in data])
        ids = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray())
        results.append(points[ids].reshape(-1, 3, points.shape[1]))
    return numpy.concatenate(results)


def in_order(triangles):
    """Sorts triangles and their corners, so that the result does not depend on ranks and cell
    types."""
    corner = numpy.unique(triangles.reshape(-1, triangles.shape[2]), axis=0, return_inverse=True)[1]
    first = corner.reshape(-1, 3).argmin(axis=1)
    turns = (first[:, None] + numpy.arange(3)) % 3
    turned = numpy.take_along_axis(triangles, turns[:, :, None], axis=1)
    rows = turned.reshape(len(triangles), -1)
    return rows[numpy.lexsort(rows.T[::-1])]


def count_open_edges(triangles):
    """Number of edges with a single triangle, by coordinates."""
    points = triangles[:, :, :3].reshape(-1, 3)
    ids = numpy.unique(points, axis=0, return_inverse=True)[1].reshape(-1, 3)
    edges = numpy.sort(numpy.concatenate([ids[:, [0, 1]], ids[:, [1, 2]], ids[:, [2, 0]]]), axis=1)
    return numpy.count_nonzero(numpy.unique(edges, axis=0, return_counts=True)[1] == 1)


def mesh(source):
    """The data of a source, without the conversions of servermanager.Fetch()."""
    source.UpdatePipeline()
    return source.GetClientSideObject().GetOutputDataObject(source.Port)


def make_plain_window():
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    return window


# Shaders of another window would be built again.
PLAIN_WINDOW = make_plain_window()


def plain_window(view, prop):
    """The window of plain VTK with a prop, and the size, the background, the lights and the camera of
    a view."""
    of_view = view.GetClientSideObject().GetRenderer()
    renderer = vtkRenderer()
    renderer.SetBackground(of_view.GetBackground())
    for light in of_view.GetLights():
        renderer.AddLight(light)
    renderer.AddViewProp(prop)
    renderer.GetActiveCamera().DeepCopy(view.GetClientSideObject().GetActiveCamera())
    renderer.ResetCameraClippingRange()
    for each in list(PLAIN_WINDOW.GetRenderers()):
        PLAIN_WINDOW.RemoveRenderer(each)
    PLAIN_WINDOW.SetSize(*view.ViewSize)
    PLAIN_WINDOW.AddRenderer(renderer)
    return PLAIN_WINDOW


@contextlib.contextmanager
def messages():
    """Captures messages. Returns a function that returns their text."""
    window, previous = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    try:
        yield window.GetOutput
    finally:
        vtkOutputWindow.SetInstance(previous)


@contextlib.contextmanager
def traced(proxy):
    """Changes properties like the panel while a trace is recorded."""
    item = smtrace.PropertiesModified(proxy.SMProxy)
    yield
    item.finalize()


class Undo:
    """Records changes like the application's buttons Undo and Redo."""

    def __init__(self):
        self.stack = vtkSMUndoStack()
        self.builder = vtkSMUndoStackBuilder()
        self.builder.SetUndoStack(self.stack)
        servermanager.vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(self.builder)

    def record(self, name, change):
        self.builder.Begin(name)
        change()
        self.builder.End()
        self.builder.PushToStack()

    def step(self, move):
        move()
        servermanager.ProxyManager().SMProxyManager.UpdateRegisteredProxiesInOrder(0)

    def end(self):
        servermanager.vtkSMProxyManager.GetProxyManager().SetUndoStackBuilder(None)


def compare_with_one_rank(path, pictures, limits):
    """On one rank, writes pictures to a file and returns the number of pictures that are almost
    empty or equal another one. On several ranks, compares with this file and returns the number of
    pictures with too many different pixels."""
    ranks = vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()
    if ranks == 1:
        numpy.savez(path, **pictures)
        # Not sum(): a programmable source replaces the built-in function by another of this name.
        empty = [name for name, picture in pictures.items() if foreground(picture) < 1000]
        alike = [
            pair
            for pair in itertools.combinations(pictures, 2)
            if differing(pictures[pair[0]], pictures[pair[1]]) < 100
        ]
        print(f"next to nothing: {empty}, alike: {alike}", flush=True)
        return len(empty) + len(alike)
    failed = 0
    expected = numpy.load(path)
    for name, picture in pictures.items():
        different = differing(picture, expected[name])
        print(f"{ranks} ranks, {name}: {different} pixels differ", flush=True)
        failed += different > limits[name]
    return failed


def clear():
    """Deletes views first: ParaView 5.11 may crash after ResetSession() with two windows."""
    for each in simple.GetViews():
        simple.Delete(each)
    for each in list(simple.GetSources().values()):
        simple.Delete(each)


def environment(**changes):
    """The environment of another process. Variables that are None are removed."""
    return {name: value for name, value in {**ENVIRONMENT, **changes}.items() if value is not None}


def run(command, cwd=None, **changes):
    """Runs another process, with changes of its environment. Returns its output."""
    result = subprocess.run(
        command,
        cwd=cwd,
        env=environment(**changes),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        timeout=180,  # no run hangs, but the machine may be busy
    )
    if result.returncode != 0:
        raise AssertionError(f"{command}: {result.returncode}\n{result.stdout}")
    # Later versions of ParaView note the request of set_properties().
    lines = result.stdout.splitlines(keepends=True)
    return "".join(line for line in lines if "Compatibility version is set to" not in line)


def run_ranks(ranks, script, *arguments, after_first="true", cwd=None, **changes):
    """Runs a script. Ranks after the first run a command of the shell before it. Returns the
    output."""
    # mpirun of Debian 13 crashes if its command line has a part for each rank.
    command = f'[ "$OMPI_COMM_WORLD_RANK" = 0 ] || {after_first}; exec pvbatch "$@"'
    mpirun = ["mpirun", "--oversubscribe", "-n", str(ranks)]
    return run([*mpirun, "sh", "-c", command, "sh", script, *arguments], cwd, **changes)


@contextlib.contextmanager
def server(ranks=1, output=None, **changes):
    """Starts pvserver, which ends after its client. Returns its port. The list `output` gets the
    lines that it prints."""
    with socket.socket() as probe:
        probe.bind(("", 0))
        port = str(probe.getsockname()[1])
    command = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
    with tempfile.TemporaryFile("w+") as file:
        process = subprocess.Popen(
            ["timeout", "180", *command, "pvserver", "--server-port=" + port],
            env=environment(**changes),
            stdout=file,
            stderr=subprocess.STDOUT,
        )
        try:
            while "Accepting" not in read_all(file):
                if process.poll() is not None:
                    raise AssertionError("pvserver does not start: " + read_all(file))
                time.sleep(0.1)
            yield port
            process.wait(60)
        finally:
            process.terminate()
            process.wait()
            if output is not None:
                output.extend(read_all(file).splitlines())


def read_all(file):
    """The text that another process has written so far. It has the same position in the file."""
    return os.pread(file.fileno(), 1 << 24, 0).decode(errors="replace")


class TestCase(unittest.TestCase):
    def tearDown(self):
        clear()

    def make_folder(self):
        """A new folder, which is removed after the test."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        return folder.name

    def assert_alike(self, one, other, pixels=0, tolerance=1):
        """Two pictures are the same, except for some pixels, and are not empty."""
        self.assertGreater(foreground(other), 600)
        self.assertLessEqual(differing(one, other, tolerance), pixels)

    def assert_message(self, told, words, of_class):
        """There is one message. It has these words, and comes from an object of this class."""
        found = re.findall(r"(vtk\w+) \(0x\w+\): (.*)", told)
        self.assertEqual(len(found), 1, told)
        self.assertEqual(found[0][0], of_class)
        self.assertIn(words, found[0][1])

    def assert_messages(self, messages, parts):
        """Each of `parts` is in one message, and each message has one of them. Messages of several
        ranks have no order: those of one rank can overtake what another prints."""
        left = list(messages)
        for part in parts:
            with self.subTest(part):
                found = [message for message in left if part in message]
                self.assertEqual(len(found), 1, messages)
                left.remove(found[0])
        self.assertEqual(left, [])

    def assert_same_picture(self, one, other, pixels=0):
        """Two views show the same, except for some pixels, and are not empty."""
        expected = picture(other)
        self.assertGreater(foreground(expected), 1000)
        self.assertLessEqual(differing(picture(one), expected), pixels)

    def compare(self, source, pixels=0, twin=None, prepare=None, styles=STYLES, **properties):
        """Compares pictures of Adaptive Refinement with these properties and of Surface."""
        views = view(), view()
        refined = show(source, views[0], styles[0], **properties)
        surface = show(twin or source, views[1], styles[1])
        for representation in refined, surface:
            if prepare:
                prepare(representation)
        simple.ResetCamera(views[1])
        copy_camera(views[1], views[0])
        self.assert_same_picture(*views, pixels)
        return refined


def main():
    """Runs the tests of the calling script. The exit status is 0 if they pass."""
    result = unittest.main(argv=["test"], exit=False, verbosity=2).result
    if not result.wasSuccessful():  # otherwise pvbatch ends MPI
        raise SystemExit(1)
