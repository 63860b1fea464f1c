# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""The functions of the package that draw."""

from __future__ import annotations

import difflib
import functools
import inspect
import os
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from . import _inputs, _raster, _results
from ._typing import Path

if TYPE_CHECKING:
    from ._drawing import Drawing
    from ._intersection import Intersection
    from ._lic import LIC
    from ._micromesh import MicroMesh
    from ._patches import Patches
    from ._refined import Refined
    from ._relief import Relief
    from ._streamlines import Streamlines
    from ._terrain import Terrain
    from ._volume import Volume

Parameters = ParamSpec("Parameters")
Result = TypeVar("Result")


def _get_options(function: Callable[..., Any]) -> list[str]:
    parameters = inspect.signature(function).parameters.values()
    return [own.name for own in parameters if own.kind != inspect.Parameter.VAR_KEYWORD]


# What other libraries and other functions of the package call an option.
_SYNONYMS = {
    "array": ("scalars", "vectors"),
    "clim": ("range",),
    "cmap": ("palette",),
    "clip_plane": ("clip",),
    "contours": ("isolines", "isosurfaces"),
    "extent": ("bounds",),
    "image": ("imagery",),
    "colormap": ("palette",),
    "levels": ("max_level", "isolines"),
    "log_scale": ("log",),
    "nodata": ("no_data",),
    "photo": ("imagery",),
    "scalars": ("array",),
    "scale": ("factor", "exaggeration"),
    "scale_factor": ("factor", "scale"),
    "shade": ("lighting",),
    "show_edges": ("edges",),
    "srs": ("crs",),
    "step": ("time",),
    "texture": ("imagery",),
    "time_step": ("time",),
    "timestep": ("time",),
    "vectors": ("warp", "array"),
    "warp_factor": ("factor",),
    "z_scale": ("exaggeration",),
    "zscale": ("exaggeration",),
}


def _find_near(option: str, allowed: list[str]) -> list[str]:
    """Return the options that are probably meant."""
    meant = [own for own in _SYNONYMS.get(option.lower(), ()) if own in allowed]
    return meant or difflib.get_close_matches(option.lower(), allowed, n=3)


def _check_options(name: str, options: Iterable[str], allowed: list[str]) -> None:
    for option in options:
        if option not in allowed:
            near = _find_near(option, allowed)
            hint = f"did you mean {' or '.join(near)}?" if near else f"it has {', '.join(allowed)}"
            raise TypeError(f"relevo.{name}() has no option {option!r}; {hint}")


def _public(function: Callable[Parameters, Result]) -> Callable[Parameters, Result]:
    """Check the names of options."""

    @functools.wraps(function)
    def checked(*arguments: Parameters.args, **options: Parameters.kwargs) -> Result:
        _check_options(function.__name__, options, _get_options(function))
        return function(*arguments, **options)

    checked.__module__ = "relevo"
    return checked


@_public
def terrain(
    source: Any,
    *,
    imagery: Path | None = None,
    exaggeration: float | None = None,
    bounds: tuple[float, float, float, float] | None = None,
    crs: Any = None,
    no_data: float | None = None,
    lighting: bool = True,
) -> Terrain:
    """Draw heights as a terrain, of any size.

    source: a raster that GDAL reads; an array of real numbers of shape (rows, columns), row 0 in
        the north, at least 2 x 2; a DataArray of xarray; or an open dataset of rasterio. An array is
        written to a temporary file. The terrain has holes at NaN and masked heights, and where the
        file declares no data.
    imagery: an image to drape over the terrain, in any coordinate system (default: colours by
        height).
    exaggeration: the factor of heights, at least 0.001 (default: 1; less without a coordinate
        system if the terrain would be higher than wide).
    bounds: (west, east, south, north) of an array, in this order, in units of crs, from border to
        border of the outermost samples (default: one unit per sample).
    crs: the coordinate system of bounds: a text such as "EPSG:4326", a number of EPSG, or an object
        with to_wkt() (default: none).
    no_data: the height of samples without data in an array, such as -9999 (default: none).
    lighting: whether lights shade the terrain (default: True). Without, its colours are those of the
        colour bar or the image.

    Colours, light and view are those of relevo-view. The terrain is within one pixel of all
    samples. mapper is a vtkTerrainMapper. A warning tells if the heights look like a photo, or the
    lowest or highest one like a value for missing data.

    Raises FileNotFoundError, relevo.Error for a file that cannot be read and for heights that are
    all missing, TypeError, and ValueError.
    """
    from ._terrain import Terrain

    return Terrain(source, imagery, exaggeration, bounds, crs, no_data, lighting)


@_public
def refined(
    mesh: Any,
    *,
    surface: Any = None,
    metric: Any = None,
    max_level: int | None = None,
    height: Any = None,
    scale: float | None = None,
    up: str = "y",
    lighting: bool = True,
    time: float | None = None,
    scalars: str | None = None,
    clip: Any = None,
    palette: str | None = None,
    range: tuple[float, float] | str | None = None,
    log: bool = False,
    below: Any = None,
    above: Any = None,
) -> Refined:
    """Draw a surface, refined where the viewer needs detail.

    mesh: a path, an object of VTK (data, algorithm, actor), a mesh of PyVista or vedo, or (points,
        faces) as arrays of shape (n, 3) and (m, 3) or (m, 4). Of 3D cells, the outer faces.
    surface: "linear", "pn", "phong", "g1", "st" (scalar-tagged), "procedural", or a
        vtkRefinementSurface (default: PN triangles with creases, or linear where they do not fit).
    metric: "screen-edge", "curvature", "distance", "silhouette", "contour", "view-dependent",
        "field", "height", or a vtkDepthTagMetric (default: "screen-edge", segments of 4 pixels;
        with height "height", an error of half a pixel).
    max_level: the highest level, from 0 to 7; an edge of level l has 2^l segments (default: 7
        for "screen-edge" and "height", 4 for other metrics, and 0 for flat faces without metric).
    height: heights that displace the surface along its normals: a path, an array as for terrain(),
        a vtkHeightField or a vtkDisplacement (default: none).
    scale: the length of one unit of height (default: 5 % of the mesh's diagonal for all heights).
    up: the vertical axis, "x", "y" or "z" (default: "y").
    lighting: whether lights shade the surface (default: True).
    time: the time of a file with time steps, or of an algorithm of VTK; the nearest step is drawn
        (default: the first one, or the current one of an algorithm). See times().
    scalars: the array of points or cells for colours, or a quantity such as "von Mises", see
        volume() (default: the active scalars).
    clip: a vtkPlane or (point, normal), each three numbers; the side of the normal is drawn. A cut
        through 3D cells is filled. You cannot combine it with height.
    palette: "viridis", "cool-warm", "cyclic", "grey", "heat", "magma", "rainbow", "relief" or
        "water" (default: "viridis").
    range: the values of the first and the last colour, or "all" for the values of all time steps of
        a file or an algorithm (default: those of the drawn step).
    log: whether colours depend on the logarithms of values, which must be above 0.
    below, above: colours of values out of range: a name such as "white", "#rrggbb", or red, green
        and blue from 0 to 1 (default: those of the ends of the range).

    mapper is a vtkAdaptiveRefinementMapper, recipe its
    vtkAdaptiveRefinement.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError.
    """
    from ._colours import Colours
    from ._options import MeshOptions
    from ._refined import Refined

    colours = Colours(palette, range, log, below, above)
    options = MeshOptions(up, lighting, time, scalars, clip, colours)
    return Refined(mesh, options, surface, metric, max_level, height, scale)


@_public
def volume(
    mesh: Any,
    array: str | None = None,
    *,
    transfer: Any = None,
    unit_distance: float | None = None,
    isosurfaces: Any = (),
    clip: Any = None,
    blend: str = "composite",
    up: str = "y",
    lighting: bool | None = None,
    time: float | None = None,
    shape_tolerance: float | None = None,
    field_tolerance: float | None = None,
    palette: str | None = None,
    range: tuple[float, float] | str | None = None,
    log: bool = False,
    below: Any = None,
    above: Any = None,
) -> Volume:
    """Draw the interior of a mesh of 3D cells.

    mesh: as for refined(), with 3D cells.
    array: the name of an array of points or cells, or "von Mises" for the equivalent stress of its
        tensors, see below (default: the active scalars, or the first array).
    transfer: colours and opacities: an array of shape (n, 5) with value, red, green, blue and
        opacity, the path of a text file with such lines, or a vtkVolumeProperty (default: by the
        array's histogram).
    unit_distance: the length for which opacities hold (default: the size of a mean cell).
    isosurfaces: values whose surfaces are drawn in the volume (default: none).
    clip: a vtkPlane or (point, normal), each three numbers; the side of the normal is drawn.
    blend: "composite", "maximum", "minimum", "average", "additive" or "isosurface".
    up: the vertical axis, "x", "y" or "z" (default: "y").
    lighting: whether gradients are shaded by lights (default: with isosurfaces).
    time: the time of a file with time steps, or of an algorithm of VTK; the nearest step is drawn
        (default: the first one, or the current one of an algorithm). See times().
    shape_tolerance: the largest error of the shape of curved cells, as a share of the diagonal of
        the mesh, from 1e-6 to 1 (default: 5e-4, half a pixel if the mesh is 1000 pixels large).
    field_tolerance: the largest error of the values in curved cells, as a share of their range,
        from 1e-6 to 1 (default: 4e-3). Reduce it if the transfer function has narrow peaks.
    palette: "viridis", "cool-warm", "cyclic", "grey", "heat", "magma", "rainbow", "relief" or
        "water" (default: "viridis").
    range: the values of the first and the last colour, or "all" for the values of all time steps of
        a file or an algorithm (default: those of the drawn step).
    log: whether colours depend on the logarithms of values, which must be above 0.
    below, above: colours of values out of range: a name such as "white", "#rrggbb", or red, green
        and blue from 0 to 1 (default: those of the ends of the range). transfer replaces these
        five options.

    Of arrays with several components, the magnitude is shown: the root of the sum of the squares of
    the stored components. For 6 components of a symmetric tensor (xx, yy, zz, xy, yz, xz) or 9 of
    any tensor this is not the von Mises stress. "von Mises" computes that at each point or cell from
    the only array of 6 or 9 components, "von Mises of S" from the array S.

    mapper is a vtkGPUUnstructuredGridVolumeMapper, actor a vtkVolume. mesh() returns the mesh.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError, which names all arrays if the
    array does not exist.
    """
    from ._colours import Colours
    from ._options import MeshOptions
    from ._volume import Volume

    colours = Colours(palette, range, log, below, above)
    options = MeshOptions(up, lighting, time, array, clip, colours)
    return Volume(
        mesh,
        options,
        transfer,
        unit_distance,
        isosurfaces,
        blend,
        shape_tolerance,
        field_tolerance,
    )


@_public
def patches(
    mesh: Any,
    *,
    scalars: str | None = None,
    warp: str | None = None,
    factor: float = 1.0,
    edges: bool = False,
    isolines: int = 0,
    error: float | None = None,
    up: str = "y",
    lighting: bool = True,
    time: float | None = None,
    clip: Any = None,
    palette: str | None = None,
    range: tuple[float, float] | str | None = None,
    log: bool = False,
    below: Any = None,
    above: Any = None,
) -> Patches:
    """Draw cells with their exact shape: quadratic, Lagrange, Bézier and rational cells.

    mesh: as for refined(). Of 3D cells, the outer faces.
    scalars: the array of points or cells for colours, evaluated with the cells' own basis at every
        pixel (default: the active scalars). Magnitudes and "von Mises" are as for volume().
    warp: an array of points with 3 components that displaces the nodes (default: none).
    factor: multiplies warp.
    edges: whether the borders of cells are drawn.
    isolines: the number of lines of equal scalars.
    error: the largest distance from the exact shape in pixels (default: 0.5).
    up: the vertical axis, "x", "y" or "z" (default: "y").
    lighting: whether lights shade the surface (default: True).
    time: the time of a file with time steps, or of an algorithm of VTK; the nearest step is drawn
        (default: the first one, or the current one of an algorithm). See times().
    clip: as for refined().
    palette: "viridis", "cool-warm", "cyclic", "grey", "heat", "magma", "rainbow", "relief" or
        "water" (default: "viridis").
    range: the values of the first and the last colour, or "all" for the values of all time steps of
        a file or an algorithm (default: those of the drawn step).
    log: whether colours depend on the logarithms of values, which must be above 0. You cannot combine
        it with isolines.
    below, above: colours of values out of range: a name such as "white", "#rrggbb", or red, green
        and blue from 0 to 1 (default: those of the ends of the range).

    mapper is a vtkAdaptivePatchMapper, recipe its vtkAdaptiveRefinement.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError, which names all arrays if an
    array does not exist.
    """
    from ._colours import Colours
    from ._options import MeshOptions
    from ._patches import Patches

    colours = Colours(palette, range, log, below, above)
    options = MeshOptions(up, lighting, time, scalars, clip, colours)
    return Patches(mesh, options, warp, factor, edges, isolines, error)


@_public
def lic(
    mesh: Any,
    vectors: str | None = None,
    *,
    up: str = "y",
    lighting: bool = True,
    time: float | None = None,
    palette: str | None = None,
    range: tuple[float, float] | str | None = None,
    log: bool = False,
    below: Any = None,
    above: Any = None,
) -> LIC:
    """Draw streaks along a vector field on a surface, by line integral convolution.

    mesh: as for refined(). The surface is refined where the vectors vary.
    vectors: the name of an array of points or cells with 2 or 3 components (default: the active
        vectors, or the first such array). Colours are their lengths.
    up: the vertical axis, "x", "y" or "z" (default: "y").
    lighting: whether lights shade the surface (default: True).
    time: the time of a file with time steps, or of an algorithm of VTK; the nearest step is drawn
        (default: the first one, or the current one of an algorithm). See times().
    palette: "viridis", "cool-warm", "cyclic", "grey", "heat", "magma", "rainbow", "relief" or
        "water" (default: "viridis").
    range: the values of the first and the last colour, or "all" for the values of all time steps of
        a file or an algorithm (default: those of the drawn step).
    log: whether colours depend on the logarithms of values, which must be above 0.
    below, above: colours of values out of range: a name such as "white", "#rrggbb", or red, green
        and blue from 0 to 1 (default: those of the ends of the range).

    mapper is a vtkAdaptiveLICMapper, recipe its vtkAdaptiveRefinement.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError, which names all arrays if the
    array does not exist or there are no vectors.
    """
    from ._colours import Colours
    from ._lic import LIC
    from ._options import MeshOptions

    colours = Colours(palette, range, log, below, above)
    return LIC(mesh, MeshOptions(up, lighting, time, colours=colours), vectors)


@_public
def streamlines(
    mesh: Any,
    vectors: str | None = None,
    *,
    seeds: int = 100,
    seed_line: Any = None,
    scalars: str | None = None,
    up: str = "y",
    lighting: bool = True,
    time: float | None = None,
    clip: Any = None,
    palette: str | None = None,
    range: tuple[float, float] | str | None = None,
    log: bool = False,
    below: Any = None,
    above: Any = None,
) -> Streamlines:
    """Draw streamlines along a vector field, as tubes, in 3D cells or on a surface.

    mesh: as for refined(). The surface of 3D cells is transparent around the lines.
    vectors: the name of an array of points or cells with 3 components (default: the active vectors,
        or the first such array).
    seeds: the number of points where lines begin, from 1 to 100000. They are in the middles of
        cells, evenly spaced in the order of the mesh.
    seed_line: two points, each three numbers; lines begin on the line between them (default: in
        cells).
    scalars: the array of points or cells for colours, or a quantity such as "von Mises", see
        volume() (default: the lengths of the vectors).
    up: the vertical axis, "x", "y" or "z" (default: "y").
    lighting: whether lights shade the surface and the lines (default: True).
    time: the time of a file with time steps, or of an algorithm of VTK; the nearest step is drawn
        (default: the first one, or the current one of an algorithm). See times().
    clip: as for refined(). Lines are not cut.
    palette: "viridis", "cool-warm", "cyclic", "grey", "heat", "magma", "rainbow", "relief" or
        "water" (default: "viridis").
    range: the values of the first and the last colour, or "all" for the values of all time steps of
        a file or an algorithm (default: those of the drawn step).
    log: whether colours depend on the logarithms of values, which must be above 0.
    below, above: colours of values out of range: a name such as "white", "#rrggbb", or red, green
        and blue from 0 to 1 (default: those of the ends of the range).

    Lines run in both directions, up to three diagonals of the mesh, until they leave it or the
    vectors vanish. A warning tells if there are none.

    The result has the attributes lines, tracer, a vtkStreamTracer, tubes, a vtkTubeFilter, and
    line_actor. mesh() and save() use the lines. mapper is a vtkAdaptiveRefinementMapper, actor and
    recipe are those of the surface.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError, which names all arrays if an
    array does not exist or there are no vectors.
    """
    from ._colours import Colours
    from ._options import MeshOptions
    from ._streamlines import Streamlines

    colours = Colours(palette, range, log, below, above)
    options = MeshOptions(up, lighting, time, scalars, clip, colours)
    return Streamlines(mesh, options, vectors, seeds, seed_line)


@_public
def relief(source: Any, *, lighting: bool | None = None) -> Relief:
    """Draw reliefs, which are images with depth.

    source: a folder that vtkReliefDatabaseWriter has written, reliefs as a vtkImageData or a
        vtkMultiBlockDataSet, or heights: a raster file, an array as for terrain(), or a
        vtkHeightField.
    lighting: whether lights shade the colours (default: those of heights).

    mapper is a vtkReliefMapper. mesh() returns the reliefs.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError.
    """
    from ._relief import Relief

    return Relief(source, lighting)


@_public
def micromesh(
    mesh: Any,
    *,
    tolerance: float | str | None = None,
    max_level: int | None = None,
    error: float = 1.0,
    isosurfaces: Any = (),
    array: str | None = None,
    up: str = "y",
    lighting: bool = True,
    time: float | None = None,
) -> MicroMesh:
    """Encode a dense mesh as a coarse mesh with displacements, and draw it.

    mesh: as for refined(), for example a scan or an isosurface; or a micro-mesh: an .rmm file or the
        output of vtkMicroMeshFilter.
    tolerance: the largest distance between the dense mesh and the result, as a length, or as a text
        such as "0.1%" in percent of the diagonal (default: "0.1%"; a micro-mesh has its own).
    max_level: the highest level of displacements, from 0 to 7; a face has up to 4^max_level
        triangles (default: 5; a micro-mesh has its own).
    error: the largest distance of the drawn surface from the result on the screen, in pixels
        (default: 1).
    isosurfaces: the values of isosurfaces of 3D cells to encode (default: none, the outer surface
        of 3D cells, with a warning). tolerance in percent is then of the diagonal of the volume.
    array: the array of points with one component for isosurfaces (default: the active scalars, or
        the first such array).
    up: the vertical axis, "x", "y" or "z" (default: "y").
    lighting: whether lights shade the surface (default: True).
    time: as for refined().

    The result has the attributes micro, a vtkPolyData, and deviation, a bound of the distances in
    both directions as a length. mesh() returns dense triangles within 1.1 times the deviation, with
    the arrays of the input, and with a camera the drawn ones. save() writes .rmm files too. mapper is a
    vtkAdaptiveRefinementMapper, recipe its vtkAdaptiveRefinement.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError.
    """
    from ._micromesh import MicroMesh
    from ._options import MeshOptions

    options = MeshOptions(up, lighting, time)
    return MicroMesh(mesh, options, tolerance, max_level, error, isosurfaces, array)


@_public
def intersection(a: Any, b: Any = None) -> Intersection:
    """Find where two surfaces meet, with exact predicates.

    a, b: meshes as for refined(). Without b, where a intersects itself.

    The result has the attributes curves, overlaps and contacts. mesh() and save() use the curves.
    actor is a vtkAssembly of the curves, in red, and both surfaces.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError.
    """
    from ._intersection import Intersection

    return Intersection(a, b)


@_public
def times(source: Any) -> list[float]:
    """Return the times of the steps of a file or of an algorithm of VTK, in increasing order.

    source: a path, as for refined(), or a vtkAlgorithm, such as a reader.

    The list is empty without time steps. Draw a step with the option time of the other functions.

    Raises FileNotFoundError, relevo.Error, TypeError, and ValueError for other files.
    """
    if _inputs.is_path(source):
        return _results.open_file(source)[0].get_times()
    if isinstance(source, vtkAlgorithm):
        return _results.AlgorithmReader(source).get_times()
    raise TypeError(f"source must be a path or a vtkAlgorithm, not {type(source).__name__}")


def _is_curved(data: vtkDataObject) -> bool:
    """Return whether a data object has curved cells."""
    cells = (cell for block in _inputs.get_blocks(data) for cell in _inputs.get_kinds_of_cells(block))
    return not all(cell.IsLinear() for cell in cells)


def _find_functions(source: Any, time: Any) -> tuple[tuple[Callable[..., Drawing], ...], Any]:
    """Return the functions that can draw a source, best first, and the source, read if needed."""
    if _inputs.is_path(source) and os.path.isdir(source):
        if not os.path.isfile(os.path.join(source, "data.csv")):
            raise ValueError(
                f"{os.fspath(source)} is a folder without reliefs; show() takes a raster, a mesh,"
                " or a folder that vtkReliefDatabaseWriter has written"
            )
        return (relief,), source
    if _raster.is_raster(source):
        return (terrain, relief), source
    if _inputs.is_path(source) and not _results.is_mesh_file(source):
        return (terrain, relief), source
    taken = _inputs.take_data(source, "the first argument", time)
    data = taken.data
    if data.IsA("vtkImageData") and data.GetFieldData().HasArray("ReliefMatrix"):
        return (relief,), data
    if data.IsA("vtkPolyData") and data.GetFieldData().HasArray("MicroMeshDisplacements"):
        return (micromesh,), taken
    if _is_curved(data):
        return (patches, volume, lic, streamlines, refined), taken
    return (refined, volume, patches, lic, streamlines, micromesh), taken


def show(source: Any, **options: Any) -> Drawing:
    """Draw anything in a window, and return when it is closed.

    source: rasters and 2-D arrays are drawn by terrain(), folders of reliefs by relief(), .rmm files
        by micromesh(), meshes with curved cells by patches() and others by refined(). Options that
        belong to another function choose that one: array= and isosurfaces= draw a volume, vectors=
        streaks, seeds= and seed_line= streamlines, and tolerance= a micro-mesh.
    options: those of one of these functions.

    Returns the drawing. Raises relevo.Error without a display, FileNotFoundError, TypeError, and
    ValueError.
    """
    functions, found = _find_functions(source, options.get("time"))
    if found is not source:
        options.pop("time", None)  # the step is read
    for function in functions:
        if set(options) <= set(_get_options(function)[1:]):
            drawing = function(found, **options)
            drawing.show()
            return drawing
    allowed = dict.fromkeys(own for function in functions for own in _get_options(function)[1:])
    _check_options("show", options, list(allowed))
    raise TypeError(f"the options {', '.join(options)} belong to different functions")


show.__module__ = "relevo"
