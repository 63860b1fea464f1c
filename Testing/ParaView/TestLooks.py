# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Proves paraview.md: Adaptive Refinement supports the display properties of Surface."""

import os
import tempfile

import numpy
from paraview import simple

import RelevoParaView as relevo
from RelevoParaView import sphere

ARRAYS = """
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
random = numpy.random.RandomState(1)
def add(attributes, name, values):
    array = numpy_to_vtk(values, deep=1)
    array.SetName(name)
    attributes.AddArray(array)
for attributes, count in (
    (output.GetPointData(), output.GetNumberOfPoints()),
    (output.GetCellData(), output.GetNumberOfCells()),
):
    add(attributes, "Number", random.rand(count))
    add(attributes, "Vector", random.rand(count, 3))
    add(attributes, "Bytes", (255 * random.rand(count, 4)).astype(numpy.uint8))
    add(attributes, "Holes", numpy.where(random.rand(count) < 0.3, numpy.nan, random.rand(count)))
add(output.GetFieldData(), "Field", numpy.array([0.3]))
"""


def with_arrays(source):
    """Scalars, vectors, colours and scalars with NaN, as point and cell data, and field data."""
    return simple.ProgrammableFilter(Input=source, Script=ARRAYS, CopyArrays=1)


def write_noise(path, size=16):
    """A picture with random pixels."""
    colours = 255 * numpy.random.RandomState(2).rand(size, size, 3)
    relevo.write_png(path, colours.astype(numpy.uint8))


def coloured(*array, table=None, opacity=None, **properties):
    """Colours by an array: arguments of ColorBy() and settings of the colour map."""

    def prepare(representation):
        simple.ColorBy(representation, array)
        for name, value in (table or {}).items():
            setattr(simple.GetColorTransferFunction(array[1]), name, value)
        if opacity:
            simple.GetOpacityTransferFunction(array[1]).Points = opacity
        relevo.set_properties(representation, properties)

    return prepare


COLOURS = {
    "points": coloured("POINTS", "Number"),
    "points, mapped first": coloured("POINTS", "Number", InterpolateScalarsBeforeMapping=0),
    "magnitude": coloured("POINTS", "Vector", "Magnitude"),
    "component": coloured("POINTS", "Vector", "Y"),
    "direct": coloured("POINTS", "Bytes", MapScalars=0),
    "cells": coloured("CELLS", "Number"),
    "cells, direct": coloured("CELLS", "Bytes", MapScalars=0),
    "cells with NaN": coloured("CELLS", "Holes", table={"NanColor": [1, 0, 1]}),
    "field data": coloured("FIELD", "Field"),
    "translucent": coloured("POINTS", "Number", Opacity=0.4),
    "opacity of numbers": coloured(
        "POINTS",
        "Number",
        table={"EnableOpacityMapping": 1},
        opacity=[0, 0, 0.5, 0, 1, 1, 0.5, 0],
    ),
}
MATERIALS = {
    "opacity": {"Opacity": 0.4},
    "colour": {"DiffuseColor": [0.2, 0.6, 0.9], "AmbientColor": [1, 0, 0], "Ambient": 0.3},
    "highlight": {"Specular": 0.7, "SpecularPower": 20},
    "flat": {"Interpolation": "Flat"},
    "physical": {"Interpolation": "PBR", "Metallic": 0.5, "Roughness": 0.4},
    "backface": {"Opacity": 0.5, "BackfaceRepresentation": "Surface", "BackfaceDiffuseColor": [1, 0, 0]},
    "backface wireframe": {"Opacity": 0.5, "BackfaceRepresentation": "Wireframe"},
    "front culled": {"BackfaceRepresentation": "Cull Frontface"},
    "moved": {"Position": [0.2, 0.1, 0]},
    "scaled": {"Scale": [1, 2, 0.5]},
    "turned": {"Orientation": [20, 30, 40], "Origin": [0.2, 0, 0]},
}
STYLES = {
    "With Edges": "Surface With Edges",
    "Wireframe": "Wireframe",
    "Points": "Points",
}


def make_texture(path):
    texture = simple.CreateTexture(path)
    texture.UpdateVTKObjects()  # ParaView 5.13 has not yet
    return texture


class TestLooks(relevo.TestCase):
    def compare_looks(self, source, looks):
        """Compares each property with Surface, whose picture must change with it."""
        views = relevo.view(), relevo.view()
        shown = relevo.show(source, views[1], "Surface")
        simple.ResetCamera(views[1])
        plain = relevo.picture(views[1])
        relevo.copy_camera(views[1], views[0])
        for name, prepare in looks.items():
            with self.subTest(name):
                simple.Delete(shown)
                shown = relevo.show(source, views[1], "Surface")
                refined = relevo.show(source, views[0], MaximumLevel=0, Metric="None")
                for representation in shown, refined:
                    prepare(representation)
                self.assert_same_picture(*views)
                self.assertGreater(relevo.differing(relevo.picture(views[1]), plain), 500)
                simple.Delete(refined)

    def test_colours(self):
        self.compare_looks(with_arrays(sphere()), COLOURS)

    def test_nan(self):
        """Triangles at NaN points, except for pixels beside these points."""
        prepare = coloured("POINTS", "Holes", table={"NanColor": [1, 0, 1]})
        self.compare(with_arrays(sphere()), 50, prepare=prepare, MaximumLevel=0, Metric="None")

    def test_materials(self):
        def sets(properties):
            return lambda representation: relevo.set_properties(representation, properties)

        self.compare_looks(sphere(), {name: sets(values) for name, values in MATERIALS.items()})

    def test_textures(self):
        mapped = simple.TextureMaptoSphere(Input=sphere())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "noise.png")
            write_noise(path)

            def textured(**properties):
                def prepare(representation):
                    representation.Texture = make_texture(path)
                    relevo.set_properties(representation, properties)

                return prepare

            looks = {
                "pixels": textured(),
                "smooth": textured(InterpolateTextures=1),
                "flipped": textured(FlipTextures=1),
                "translucent": textured(Opacity=0.5),
            }
            self.compare_looks(mapped, looks)

    def test_terrain_with_photo(self):
        """Compares with the filter's mesh of the same terrain."""
        with tempfile.TemporaryDirectory() as folder:
            heights, photo = (os.path.join(folder, name) for name in ("heights.png", "photo.png"))
            relevo.write_heights(heights)
            write_noise(photo)
            terrain = simple.TerrainSource(FileName=heights, Resolution=8)
            mesh = simple.AdaptiveRefinement(Input=terrain, MaximumLevel=3, Metric="None")

            def displace(proxy):
                proxy.Displacement = "Height Map"
                proxy.Displacement.HeightMapFileName = heights
                proxy.Displacement.AlongNormals = 0

            def prepare(representation):
                representation.Texture = make_texture(photo)
                if representation.Representation == "Adaptive Refinement":
                    displace(representation)

            displace(mesh)
            self.compare(terrain, 20, mesh, prepare, MaximumLevel=3, Metric="None")

    def test_edges_wireframe_and_points(self):
        """Properties of the mesh, and of its refinement by the filter."""
        mesh = simple.AdaptiveRefinement(Input=sphere(), MaximumLevel=2, Metric="None")
        thick = {"LineWidth": 3, "PointSize": 6, "EdgeColor": [1, 0, 0]}
        for own, style in STYLES.items():
            for level, twin in (0, sphere()), (2, mesh):
                with self.subTest(style, level=level):
                    self.compare(
                        sphere(),
                        5,
                        twin,
                        lambda each: relevo.set_properties(each, thick),
                        styles=("Adaptive Refinement " + own, style),
                        MaximumLevel=level,
                        Metric="None",
                    )


if __name__ == "__main__":
    relevo.main()
