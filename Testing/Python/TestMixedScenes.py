# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves that a refined surface beside a volume and an image slice is drawn and picked like the
filter's output in a vtkPolyDataMapper."""

import contextlib
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPiecewiseFunction
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkAreaPicker, vtkCellPicker, vtkColorTransferFunction, vtkImageSlice,
    vtkImageSliceMapper, vtkPolyDataMapper, vtkPropPicker, vtkRenderedAreaPicker, vtkRenderer,
    vtkRenderWindow, vtkScenePicker, vtkVolume, vtkVolumeProperty)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401: the implementation of windows
from vtkmodules.vtkRenderingVolumeOpenGL2 import vtkOpenGLGPUVolumeRayCastMapper

import relevo

SIZE = 180
PIXELS = [(x, y) for x in range(5, SIZE, 17) for y in range(8, SIZE, 17)]
AREAS = [(x, y, x + 24, y + 17) for x in range(0, SIZE - 24, 31) for y in range(0, SIZE - 17, 31)]


def image(dimensions, spacing, origin, values):
    result = vtkImageData()
    result.SetDimensions(dimensions)
    result.SetSpacing(spacing)
    result.SetOrigin(origin)
    result.GetPointData().SetScalars(numpy_to_vtk(values.astype(numpy.uint8).ravel(), deep=True))
    return result


def make_volume():
    """A fuzzy ball, to the right of the surface and partly behind it."""
    grid = numpy.indices((12, 12, 12)) - 5.5
    ball = 255 * numpy.clip(1.0 - numpy.sqrt((grid * grid).sum(axis=0)) / 5.5, 0, 1)
    mapper = vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputData(image((12, 12, 12), (0.1, 0.1, 0.1), (0.1, -0.5, -0.9), ball))
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 0.0)
    opacity.AddPoint(255, 0.9)
    color = vtkColorTransferFunction()
    color.AddRGBPoint(0, 0.1, 0.2, 1.0)
    color.AddRGBPoint(255, 1.0, 0.9, 0.1)
    prop = vtkVolumeProperty()
    prop.SetScalarOpacity(opacity)
    prop.SetColor(color)
    volume = vtkVolume()
    volume.SetMapper(mapper)
    volume.SetProperty(prop)
    return volume


def make_slice():
    """Stripes, above the surface and through it."""
    values = 40 + 30 * (numpy.indices((10, 16))[1] % 6)
    mapper = vtkImageSliceMapper()
    mapper.SetInputData(image((16, 10, 1), (0.1, 0.1, 1), (-1.1, 0.1, 0.2), values))
    result = vtkImageSlice()
    result.SetMapper(mapper)
    result.GetProperty().SetColorWindow(255)
    result.GetProperty().SetColorLevel(128)
    return result


class Scene:
    """`mapper` draws the surface."""

    def __init__(self, mapper):
        self.surface = vtkActor()
        self.surface.SetMapper(mapper)
        self.surface.SetPosition(-0.35, -0.1, 0.0)
        self.props = [self.surface, make_volume(), make_slice()]
        self.renderer = vtkRenderer()
        for prop in self.props:
            self.renderer.AddViewProp(prop)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.4, -0.8, 4.0)
        camera.SetFocalPoint(0.0, 0.1, 0.0)
        camera.SetClippingRange(1.0, 8.0)
        self.window.Render()

    def picture(self):
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, SIZE - 1, SIZE - 1, 0, pixels, 0)
        return vtk_to_numpy(pixels).reshape(SIZE, SIZE, 3).astype(int)

    def number(self, prop):
        """The index of a picked prop, or -1."""
        return self.props.index(prop) if prop else -1

    def input_cell(self, cell):
        ids = self.surface.GetMapper().GetInput().GetCellData().GetArray("vtkOriginalCellIds")
        return int(ids.GetValue(cell)) if ids and cell >= 0 else cell


def make_scenes(level):
    """One scene with the mapper, and one with VTK's mapper and the filter's output, or the input at
    level 0."""
    source = vtkSphereSource()
    source.SetThetaResolution(10)
    source.SetPhiResolution(8)
    source.Update()
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMaximumLevel(level)
    twin = vtkPolyDataMapper()
    twin.SetInputData(source.GetOutput())
    if level > 0:
        recipe.SetSurface(relevo.vtkPNTriangleSurface())
        displacement = relevo.vtkDisplacement()
        displacement.SetOffset(0.1)
        recipe.SetDisplacement(displacement)
        refiner = relevo.vtkAdaptiveRefinementFilter()
        refiner.SetInputData(source.GetOutput())
        refiner.SetRefinement(recipe)
        twin.SetInputConnection(refiner.GetOutputPort())
    mapper = relevo.vtkAdaptiveRefinementMapper()
    mapper.SetInputData(source.GetOutput())
    mapper.SetRefinement(recipe)
    return Scene(mapper), Scene(twin)


class TestMixedScenes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scenes = [make_scenes(level) for level in (0, 3)]

    @classmethod
    def tearDownClass(cls):
        cls.scenes = None

    def compare(self, pick, places, least):
        """Both scenes agree almost everywhere: on a silhouette, a pixel may belong to either prop.
        """
        for refining, twin in self.scenes:
            found = [pick(refining, place) for place in places]
            expected = [pick(twin, place) for place in places]
            differing = [pair for pair in zip(places, found, expected) if pair[1] != pair[2]]
            self.assertLessEqual(len(differing), 1, differing)
            for number, count in enumerate(least):
                self.assertGreaterEqual(
                    sum(number in (picked if isinstance(picked, tuple) else (picked,))
                        for picked in expected), count, f"prop {number}")

    def test_pictures(self):
        for refining, twin in self.scenes:
            picture, expected = refining.picture(), twin.picture()
            differing = (abs(picture - expected) > 3).any(axis=2).sum()
            self.assertLessEqual(differing, 3)
            # The surface, the ball and the stripes are all visible.
            for prop in twin.props:
                prop.VisibilityOff()
                twin.window.Render()
                hidden = (abs(twin.picture() - expected) > 3).any(axis=2).sum()
                self.assertGreater(hidden, 300)
                prop.VisibilityOn()
            # Nothing remains of the last frame.
            refining.window.Render()
            self.assertTrue((refining.picture() == picture).all())

    def test_prop_picker(self):
        def pick(scene, place):
            picker = vtkPropPicker()
            picker.Pick(*place, 0, scene.renderer)
            return scene.number(picker.GetViewProp())

        self.compare(pick, PIXELS, (15, 3, 8))

    def test_cell_picker(self):
        def pick(scene, place):
            picker = vtkCellPicker()
            picker.Pick(*place, 0, scene.renderer)
            number = scene.number(picker.GetViewProp())
            cell = picker.GetCellId()
            return number, scene.input_cell(cell) + 1000 if number == 0 else cell + 10000

        self.compare(pick, PIXELS, (15, 3, 8))

    def test_area_picker(self):
        def pick(scene, area):
            picker = vtkAreaPicker()
            picker.AreaPick(*area, scene.renderer)
            props = picker.GetProp3Ds()
            return tuple(sorted(
                scene.number(props.GetItemAsObject(i)) for i in range(props.GetNumberOfItems())))

        self.compare(pick, AREAS, (8, 8, 8))

    def test_rendered_area_picker(self):
        def pick(scene, area):
            picker = vtkRenderedAreaPicker()
            picker.AreaPick(*area, scene.renderer)
            return scene.number(picker.GetViewProp())

        self.compare(pick, AREAS, (5, 1, 3))

    @contextlib.contextmanager
    def scene_picking(self, points):
        """A function that picks props with their points, or with the input's cells."""
        pickers = {}

        def pick(scene, place):
            if scene not in pickers:
                pickers[scene] = vtkScenePicker()
                pickers[scene].SetEnableVertexPicking(points)
                pickers[scene].SetRenderer(scene.renderer)
            picker = pickers[scene]
            number = scene.number(picker.GetViewProp(place))
            if number != 0:
                return number, -1
            return 0, 1000 + (
                picker.GetVertexId(place) if points else scene.input_cell(picker.GetCellId(place)))

        try:
            yield pick
        finally:
            for picker in pickers.values():
                picker.SetRenderer(None)  # otherwise it crashes if the window is deleted first

    def test_scene_picker_cells(self):
        with self.scene_picking(points=False) as pick:
            self.compare(pick, PIXELS, (15, 3, 8))

    def test_scene_picker_points(self):
        refining, twin = self.scenes[0]
        everywhere = [(x, y) for x in range(SIZE) for y in range(SIZE)]
        with self.scene_picking(points=True) as pick:
            found = [pick(refining, place) for place in everywhere]
            self.assertGreater(len(set(found)), 20)
            self.assertEqual(found, [pick(twin, place) for place in everywhere])


if __name__ == "__main__":
    unittest.main(argv=["TestMixedScenes"])
