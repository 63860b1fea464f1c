# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Shows vectors on surfaces by their streaks, without a display: flow.py NAME PICTURE.png [FILE]

NAME is one of
  fields    a sphere and a torus with vectors that are formulae
  levels    a coarse torus, refined where the vectors turn, with the levels beside it
  looks     ways to combine streaks with colours, and contrasts
  oriented  streaks that have heads, of sparse noise
and, of a FILE of yours or of VTK's data,
  plane     SurfaceVectors.vtk: a section through a reactor
  disk      disk_out_ref_surface.vtp: the reactor's rotating disk, where its walls have no flow
  office    office.binary.vtk: the air of a room, on slices through it
"""

import math
import sys

import relevo
from arguments import check_file, read_arguments
from figure import Figure, draw_recipe, show_edges
from meshes import make_mesh, set_normals, set_point_array
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter, vtkPolyDataNormals, vtkThreshold
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOLegacy import vtkDataSetReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkActor, vtkColorTransferFunction

# From slow to fast; light enough to carry streaks.
SPEEDS = (
    (0.29, 0.27, 0.62),
    (0.20, 0.55, 0.72),
    (0.36, 0.78, 0.58),
    (0.93, 0.86, 0.42),
    (0.95, 0.52, 0.25),
)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def make_sphere(field, around=48, across=24):
    """Points p of the unit sphere, and the vectors field(p) there."""
    points = [(0.0, 0.0, -1.0)]
    for j in range(1, across):
        b = math.pi * (j / across - 0.5)
        for i in range(around):
            a = 2 * math.pi * i / around
            points.append((math.cos(b) * math.cos(a), math.cos(b) * math.sin(a), math.sin(b)))
    points.append((0.0, 0.0, 1.0))
    triangles, last = [], len(points) - 1
    for i in range(around):
        k = (i + 1) % around
        triangles.append((0, 1 + k, 1 + i))
        triangles.append((last, last - around + i, last - around + k))
        for j in range(across - 2):
            a, b = 1 + j * around, 1 + (j + 1) * around
            triangles += [(a + i, a + k, b + k), (a + i, b + k, b + i)]
    mesh = make_mesh(points, triangles)
    set_normals(mesh, points)
    set_point_array(mesh, "Flow", [field(p) for p in points])
    return mesh


def make_torus(field, around=60, across=30, thickness=0.42):
    """A torus around z, u running around it and v around its tube, and the vectors
    a * e_u + b * e_v there, e_u and e_v being the unit vectors in these directions and
    (a, b) = field(u, v)."""
    points, normals, vectors, triangles = [], [], [], []
    for i in range(around):
        u = 2 * math.pi * i / around
        e_u = (-math.sin(u), math.cos(u), 0.0)
        for j in range(across):
            v = 2 * math.pi * j / across
            normal = (math.cos(v) * math.cos(u), math.cos(v) * math.sin(u), math.sin(v))
            radius = 1 + thickness * math.cos(v)
            points.append((radius * math.cos(u), radius * math.sin(u), thickness * math.sin(v)))
            normals.append(normal)
            a, b = field(u, v)
            vectors.append(tuple(a * s + b * t for s, t in zip(e_u, cross(normal, e_u))))
            c, d = i * across, (i + 1) % around * across
            k = (j + 1) % across
            triangles += [(c + j, d + j, d + k), (c + j, d + k, c + k)]
    mesh = make_mesh(points, triangles)
    set_normals(mesh, normals)
    set_point_array(mesh, "Flow", vectors)
    return mesh


def swirls(p):
    """A sum of rotations about axes a, the nearer to a the faster, some of them backwards:
    v(p) = sum of s * exp(4 (a.p - 1)) * a x p."""
    v = (0.0, 0.0, 0.0)
    for s, a in (
        (1.0, (0.36, -0.8, 0.48)),
        (-1.0, (-0.48, -0.6, 0.64)),
        (0.8, (-0.6, -0.8, 0.0)),
        (-0.9, (0.6, -0.64, -0.48)),
        (0.6, (-0.28, -0.96, -0.4)),
        (0.8, (0.8, 0.36, 0.48)),
        (-0.7, (0.0, 0.6, 0.8)),
    ):
        share = s * math.exp(4 * (sum(x * y for x, y in zip(a, p)) - 1))
        v = tuple(x + share * y for x, y in zip(v, cross(a, p)))
    return v


def waves(u, v):
    """Along the torus, and across it to and fro."""
    return 0.6 + 0.5 * math.cos(v), math.sin(3 * u) + 0.4 * math.cos(2 * v)


def make_colours(highest):
    colours = vtkColorTransferFunction()
    for i, colour in enumerate(SPEEDS):
        colours.AddRGBPoint(highest * i / (len(SPEEDS) - 1), *colour)
    colours.SetVectorModeToMagnitude()
    return colours


def make_recipe(level=0, metric=None, surface=None):
    recipe = relevo.vtkAdaptiveRefinement()
    recipe.SetMaximumLevel(level)
    recipe.SetMetric(metric)
    recipe.SetSurface(surface)
    return recipe


def draw_flow(mesh, name, highest, recipe):
    """Streaks along the vectors of that name, coloured by their length up to the highest."""
    mapper = relevo.vtkAdaptiveLICMapper()
    mapper.SetInputData(mesh)
    mapper.SetRefinement(recipe)
    mapper.SetInputArrayToProcess(0, 0, 0, 0, name)  # 0: of points
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    mapper.SetLookupTable(make_colours(highest))
    mapper.InterpolateScalarsBeforeMappingOn()
    # Streaks as the lightness of the colours, over its whole range but for the darkest part.
    mapper.SetColorModeToMultiply()
    mapper.SetEnhanceContrastToLIC()
    mapper.SetMapModeBias(0.3)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetAmbient(0.35)
    actor.GetProperty().SetDiffuse(0.75)
    return actor


def add_legend(renderer, table, title, left=0.87):
    legend = vtkScalarBarActor()
    legend.SetLookupTable(table)
    legend.SetTitle(title)
    legend.SetNumberOfLabels(3)
    legend.SetLabelFormat("%.3g")
    legend.SetTextPositionToPrecedeScalarBar()
    legend.SetPosition(left, 0.03)
    legend.SetWidth(0.11)
    legend.SetHeight(0.36)
    legend.SetBarRatio(0.25)
    legend.UnconstrainedFontSizeOn()
    legend.SetVerticalTitleSeparation(6)
    for text in (legend.GetTitleTextProperty(), legend.GetLabelTextProperty()):
        text.SetFontSize(12)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    renderer.AddViewProp(legend)


def fields():
    """Refined twice, so that the sphere and the torus are round."""
    figure = Figure(2, 1, (480, 420), (0, -1, 0.35), (0, 0, 1), 1.35)
    recipe = make_recipe(2, surface=relevo.vtkPNTriangleSurface())
    for label, mesh, highest, view in (
        ("swirls on a sphere", make_sphere(swirls), 0.6, (0, -1, 0.35)),
        ("waves along a torus", make_torus(waves), 1.6, (0, -1, 0.9)),
    ):
        actor = draw_flow(mesh, "Flow", highest, recipe)
        add_legend(figure.add(label, actor, view), actor.GetMapper().GetLookupTable(), "|v|")
    return figure


def levels():
    """Curved triangles over a coarse mesh, fine where the vectors turn."""
    coarse = make_torus(waves, 20, 9)
    metric = relevo.vtkFieldVariationDepthTagMetric()
    metric.SetArrayName("Flow")
    curved = make_recipe(3, metric, relevo.vtkPNTriangleSurface())
    curved.SetLevelRuleToPerEdge()
    figure = Figure(3, 1, (400, 300), (0, -1, 0.9), (0, 0, 1), 1.45)
    actor = draw_flow(coarse, "Flow", 1.6, make_recipe())
    figure.add(f"{coarse.GetNumberOfCells()} triangles", actor)
    figure.add("refined where the vectors turn", draw_flow(coarse, "Flow", 1.6, curved))
    coloured = draw_recipe(coarse, curved)
    coloured.GetMapper().SetColorModeToLevel()
    coloured.GetMapper().ScalarVisibilityOn()
    coloured.GetProperty().SetAmbient(0.3)
    coloured.GetProperty().SetSpecular(0)
    show_edges(coloured)
    table = coloured.GetMapper().GetLevelLookupTable()
    add_legend(figure.add("its levels", coloured), table, "", 0.82)
    return figure


def looks():
    """The settings are the defaults but for the mode and the contrast."""
    mesh = make_sphere(swirls)
    recipe = make_recipe(2, surface=relevo.vtkPNTriangleSurface())
    figure = Figure(4, 2, (270, 270), (0, -1, 0.35), (0, 0, 1), 1.35)
    for mode in ("Blend", "Multiply"):
        for contrast in ("Off", "LIC", "Color", "Both"):
            actor = draw_flow(mesh, "Flow", 0.6, recipe)
            mapper = actor.GetMapper()
            getattr(mapper, f"SetColorModeTo{mode}")()
            getattr(mapper, f"SetEnhanceContrastTo{contrast}")()
            mapper.SetMapModeBias(0)
            figure.add(f"{mode}, contrast {contrast}", actor)
    return figure


def oriented():
    """Dark spots on a light ground, drawn out: darkest where they arrive."""
    mesh = make_sphere(swirls)
    recipe = make_recipe(2, surface=relevo.vtkPNTriangleSurface())
    figure = Figure(2, 1, (480, 420), (0, -1, 0.35), (0, 0, 1), 1.35)
    actor = draw_flow(mesh, "Flow", 0.6, recipe)
    figure.add("streaks", actor)
    actor = draw_flow(mesh, "Flow", 0.6, recipe)
    mapper = actor.GetMapper()
    mapper.OrientedLICOn()
    mapper.EnhancedLICOff()
    mapper.SetNumberOfSteps(30)
    mapper.SetNoiseType(mapper.NOISE_TYPE_UNIFORM)
    mapper.SetMaxNoiseValue(0.02)
    mapper.SetImpulseNoiseBackgroundValue(1)
    mapper.SetImpulseNoiseProbability(0.02)
    mapper.SetNoiseGrainSize(3)
    mapper.SetLowLICContrastEnhancementFactor(0.5)
    mapper.SetMapModeBias(0)
    figure.add("streaks with heads", actor)
    return figure


def read(filename):
    reader = vtkXMLPolyDataReader() if filename.endswith(".vtp") else vtkDataSetReader()
    reader.SetFileName(check_file(filename))
    reader.Update()
    if reader.GetOutput().GetNumberOfPoints() == 0:
        sys.exit(f"flow.py: there are no points in {filename!r}")
    return reader.GetOutput()


def get_surface(data):
    surface = vtkGeometryFilter()
    surface.SetInputData(data)
    surface.Update()
    return surface.GetOutput()


def make_plane(origin, normal):
    result = vtkPlane()
    result.SetOrigin(origin)
    result.SetNormal(normal)
    return result


def cut(data, origin, normal):
    cutter = vtkCutter()
    cutter.SetInputData(data)
    cutter.SetCutFunction(make_plane(origin, normal))
    cutter.Update()
    return cutter.GetOutput()


def draw_still(data, name):
    """The cells in which nothing moves: the furniture of a room."""
    still = vtkThreshold()
    still.SetInputData(data)
    still.SetInputArrayToProcess(0, 0, 0, 0, name)
    still.SetComponentModeToUseAll()
    still.AllScalarsOn()
    still.SetLowerThreshold(-1e-12)
    still.SetUpperThreshold(1e-12)
    still.Update()
    return draw_recipe(get_surface(still.GetOutput()), make_recipe())


def show_no_flow(mapper):
    """Grey where the vectors are zero, in place of the colour of the slowest."""
    mapper.SetMaskColor(0.62, 0.62, 0.66)
    mapper.SetMaskIntensity(1)


def plane(filename):
    """The gas comes in from above. Between it and what rises over the disk it stands still."""
    figure = Figure(1, 1, (720, 480), (1, 0, 0), (0, 0, 1), 1.35)
    actor = draw_flow(get_surface(read(filename)), "V", 15, make_recipe())
    actor.GetProperty().LightingOff()
    renderer = figure.add("a section through a reactor", actor)
    renderer.GetActiveCamera().SetWindowCenter(0.08, -0.06)
    add_legend(renderer, actor.GetMapper().GetLookupTable(), "|V|")
    return figure


def disk(filename):
    """A disk on a shaft that turns, and the gap below that the gas leaves through; the wall around
    them is cut open. Where nothing flows it is grey."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(read(filename))
    normals.SetFeatureAngle(30)
    normals.Update()
    recipe = make_recipe(3, surface=relevo.vtkPNTriangleSurface())
    actor = draw_flow(normals.GetOutput(), "V", 20, recipe)
    actor.GetProperty().SetAmbient(0.5)
    mapper = actor.GetMapper()
    show_no_flow(mapper)
    mapper.AddClippingPlane(make_plane((0, -3.95, 0), (0, 1, 0)))
    mapper.AddClippingPlane(make_plane((0, 0, 4), (0, 0, -1)))
    figure = Figure(1, 1, (720, 480), (0.2, -1, 0.55), (0, 0, 1), 1.35)
    renderer = figure.add("a disk that turns, in a wall that is cut open", actor)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, -2.6)
    add_legend(renderer, mapper.GetLookupTable(), "|V|")
    return figure


def office(filename):
    """The air comes in at the foot of the wall to the left, and leaves below the ceiling."""
    room = read(filename)
    figure = Figure(1, 1, (720, 480), (0.45, -1, 0.95), (0, 0, 1))
    renderer = figure.add("the air of a room", draw_still(room, "vectors"))
    for origin, normal in (
        ((0, 0, 0.3), (0, 0, 1)),
        ((0, 4.2, 0), (0, 1, 0)),
        ((0.3, 0, 0), (1, 0, 0)),
    ):
        actor = draw_flow(cut(room, origin, normal), "vectors", 0.25, make_recipe())
        actor.GetProperty().LightingOff()
        renderer.AddActor(actor)
    renderer.ResetCamera()
    camera = renderer.GetActiveCamera()
    camera.Dolly(1.15)
    camera.SetWindowCenter(0.02, -0.1)
    renderer.ResetCameraClippingRange()
    add_legend(renderer, actor.GetMapper().GetLookupTable(), "|v|")
    return figure


FORMULAE = {figure.__name__: figure for figure in (fields, levels, looks, oriented)}
FILES = {figure.__name__: figure for figure in (plane, disk, office)}


def main(name, picture, *filename):
    print((FORMULAE | FILES)[name](*filename).write(picture), "triangles")


arguments = read_arguments()
if not (
    (len(arguments) == 2 and arguments[0] in FORMULAE)
    or (len(arguments) == 3 and arguments[0] in FILES)
):
    sys.exit(
        f"flow.py NAME PICTURE.png, NAME one of {', '.join(FORMULAE)}; "
        f"flow.py NAME PICTURE.png FILE, NAME one of {', '.join(FILES)}"
    )
main(*arguments)
