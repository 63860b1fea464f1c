# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves guide.md from Python: settings, statistics, errors and a picture of the mapper."""

import sys
import unittest

try:
    import numpy  # noqa: F401  for numpy_support
except ImportError:
    print("skipped: no numpy")
    sys.exit(125)

import relevo
from vtkmodules.vtkCommonCore import vtkCommand, vtkFloatArray, vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)
from vtkmodules.util.numpy_support import vtk_to_numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  makes render windows


def sphere():
    source = vtkSphereSource()
    source.SetThetaResolution(10)
    source.SetPhiResolution(8)
    source.Update()
    return source.GetOutput()


def tagged_sphere():
    """A sphere with depth-tags from 0 to 4."""
    mesh = sphere()
    tags = vtkFloatArray()
    tags.SetName("DepthTag")
    for i in range(mesh.GetNumberOfPoints()):
        tags.InsertNextValue(i * 7919 % 5)
    mesh.GetPointData().AddArray(tags)
    return mesh


class View:
    """A window with one actor."""

    def __init__(self, mesh):
        self.recipe = relevo.vtkAdaptiveRefinement()
        self.mapper = relevo.vtkAdaptiveRefinementMapper()
        self.mapper.SetInputData(mesh)
        self.mapper.SetRefinement(self.recipe)
        self.actor = vtkActor()
        self.actor.SetMapper(self.mapper)
        self.renderer = vtkRenderer()
        self.renderer.AddActor(self.actor)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(200, 200)
        self.window.AddRenderer(self.renderer)
        self.renderer.ResetCamera()

    def draw(self):
        """Number of pixels that are not black."""
        self.window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.ReadFrontBufferOff()
        grab.Update()
        pixels = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
        return int((pixels.max(axis=1) > 0).sum())


class TestAdaptiveRefinementMapper(unittest.TestCase):
    def test_statistics(self):
        mesh = sphere()
        view = View(mesh)
        self.assertIs(view.mapper.GetRefinement(), view.recipe)
        view.recipe.SetMaximumLevel(3)
        self.assertGreater(view.draw(), 1000)
        mapper = view.mapper
        drawn = mapper.GetNumberOfDrawnTriangles()
        self.assertEqual(
            drawn + mapper.GetNumberOfCulledTriangles(), mesh.GetNumberOfPolys() * 64
        )
        self.assertLess(drawn, mesh.GetNumberOfPolys() * 64)  # back faces are culled
        self.assertEqual(mapper.GetNumberOfCoarseFaces(), mesh.GetNumberOfPolys())
        self.assertEqual(mapper.GetNumberOfSelections(), 1)
        self.assertEqual(mapper.GetNumberOfUsedPatterns(), 1)
        self.assertIn(mapper.GetNumberOfDrawCalls(), (1, 2))
        self.assertGreater(mapper.GetGraphicsMemorySize(), 0)
        view.draw()
        self.assertEqual(mapper.GetNumberOfSelections(), 1)
        self.assertIn("NumberOfDrawnTriangles", str(mapper))

    def test_twin(self):
        mesh = tagged_sphere()
        view = View(mesh)
        view.recipe.SetSurface(relevo.vtkPNTriangleSurface())
        view.draw()
        twin = relevo.vtkAdaptiveRefinementFilter()
        twin.SetInputData(mesh)
        twin.SetRefinement(view.recipe)
        twin.Update()
        self.assertEqual(
            view.mapper.GetNumberOfDrawnTriangles() + view.mapper.GetNumberOfCulledTriangles(),
            twin.GetOutput().GetNumberOfPolys(),
        )
        for ours, theirs in zip(view.mapper.GetBounds(), twin.GetOutput().GetBounds()):
            self.assertGreaterEqual(abs(ours), abs(theirs) - 1e-6)
            self.assertLess(abs(ours), abs(theirs) * 1.1)

    def test_patterns(self):
        """Faces of each pattern are those of the depth-tags, with both processors."""
        mesh = tagged_sphere()
        tags = mesh.GetPointData().GetArray("DepthTag")
        table = relevo.vtkRefinementPatternTable()
        expected = {}
        for cell in range(mesh.GetNumberOfCells()):
            corners = mesh.GetCell(cell).GetPointIds()
            depths = [tags.GetValue(corners.GetId(i)) for i in range(3)]
            levels = [int((depths[i] + depths[i - 1]) / 2 + 0.5) for i in range(3)]
            levels.sort(reverse=True)
            pattern = vtkPolyData()
            table.GetPattern(*levels, pattern)
            faces, triangles = expected.get(tuple(levels), (0, 0))
            expected[tuple(levels)] = faces + 1, triangles + pattern.GetNumberOfPolys()
        self.assertGreater(len(expected), 5)
        rows = [
            tuple(2**level for level in levels) + expected[levels]
            for levels in sorted(expected, reverse=True)
        ]
        for device in ("CPU", "GPU"):
            view = View(mesh)
            view.recipe.SetMaximumLevel(4)
            getattr(view.mapper, f"SetSelectionDeviceTo{device}")()
            view.mapper.FrustumCullingOff()
            view.mapper.BackFaceCullingOff()
            view.draw()
            counts = vtkIdTypeArray()
            view.mapper.GetPatternCounts(counts)
            self.assertEqual(
                [counts.GetTuple(i) for i in range(counts.GetNumberOfTuples())], rows, device
            )
        # Culled faces do not count.
        view.mapper.BackFaceCullingOn()
        view.mapper.FrustumCullingOn()
        view.draw()
        view.mapper.GetPatternCounts(counts)
        drawn = sum(counts.GetTuple(i)[4] for i in range(counts.GetNumberOfTuples()))
        self.assertEqual(drawn, view.mapper.GetNumberOfDrawnTriangles())
        self.assertLess(drawn, sum(row[4] for row in rows))

    def test_bounds_follow_offset(self):
        plane = vtkPlaneSource()
        plane.Update()
        view = View(plane.GetOutput())
        displacement = relevo.vtkDisplacement()
        view.recipe.SetDisplacement(displacement)
        displacement.SetOffset(2)
        self.assertEqual(
            [round(x, 5) for x in view.mapper.GetBounds()], [-0.5, 0.5, -0.5, 0.5, 2, 2]
        )

    def test_errors(self):
        view = View(sphere())
        messages = []

        def note(caller, event, text):
            messages.append(text)

        note.CallDataType = "string0"
        view.mapper.AddObserver(vtkCommand.ErrorEvent, note)
        view.mapper.SetRefinement(None)
        self.assertEqual(view.draw(), 0)
        self.assertEqual(view.draw(), 0)
        self.assertEqual(len(messages), 1)
        self.assertIn("no recipe", messages[0])
        self.assertEqual(view.mapper.GetNumberOfDrawnTriangles(), 0)

    def test_documentation(self):
        text = " ".join(relevo.vtkAdaptiveRefinementMapper.__doc__.split())
        self.assertIn("on the GPU in each frame", text)


if __name__ == "__main__":
    unittest.main(argv=["TestAdaptiveRefinementMapper"])
