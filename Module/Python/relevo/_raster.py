# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes rasters of numpy arrays, and of the objects of xarray and rasterio."""

from __future__ import annotations

import html
import os
import pathlib
import shutil
import sys
import tempfile
import weakref
from typing import TYPE_CHECKING, Any

import numpy
from vtkmodules.vtkCommonCore import vtkObject

from . import arrays
from ._inputs import check_number, get_package
from ._messages import warn
from ._typing import Bounds

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

_TYPES = {
    "uint8": "Byte",
    "int16": "Int16",
    "uint16": "UInt16",
    "int32": "Int32",
    "uint32": "UInt32",
    "float32": "Float32",
    "float64": "Float64",
}


def is_raster(source: object) -> bool:
    """Return whether a source is an array of two dimensions, or a raster of xarray or rasterio."""
    if get_package(source) in ("rasterio", "xarray"):
        return True
    return isinstance(source, numpy.ndarray)


_ORDER = "(west, east, south, north)"
_TURNED = "they look like (west, south, east, north)"
_SMALL = 0.05  # share of the extent, if bounds are read in the other order


def _check_bounds(bounds: Any) -> Bounds:
    try:
        west, east, south, north = (float(number) for number in bounds)
    except (TypeError, ValueError):
        raise TypeError(f"bounds must be {_ORDER}, not {bounds!r}") from None
    width, height = south - west, north - east  # if the order is west, south, east, north
    if not (west < east and south < north) or not numpy.isfinite([west, east, south, north]).all():
        hint = f"; {_TURNED}" if width > 0 and height > 0 else ""
        raise ValueError(
            f"bounds must be {_ORDER} with west < east and south < north, not {tuple(bounds)}{hint}"
        )
    if 0 < width < _SMALL * (east - west) and 0 < height < _SMALL * (north - south):
        warn(
            f"bounds are {_ORDER}, so the array extends {east - west:g} to the east and"
            f" {north - south:g} to the north; {_TURNED}"
        )
    return west, east, south, north


def _make_crs_text(crs: Any) -> str:
    if hasattr(crs, "to_wkt"):
        return str(crs.to_wkt())
    if isinstance(crs, (int, numpy.integer)) and not isinstance(crs, bool):
        return f"EPSG:{crs}"
    if isinstance(crs, str):
        return crs
    raise TypeError(
        "crs must be a text such as 'EPSG:4326', a number of EPSG, or an object of pyproj or"
        f" rasterio, not {type(crs).__name__}"
    )


def _find_folder() -> str | None:
    """Return a folder for large temporary files, or None for the default one.

    /tmp can be in memory. /var/tmp is on a disk.
    """
    chosen = any(os.environ.get(name) for name in ("TMPDIR", "TEMP", "TMP"))
    usable = os.path.isdir("/var/tmp") and os.access("/var/tmp", os.W_OK | os.X_OK)
    return "/var/tmp" if usable and not chosen and tempfile.gettempdir() == "/tmp" else None


def _write(
    heights: ArrayLike, bounds: Bounds | None, crs: Any, no_data: float | None, folder: pathlib.Path
) -> tuple[str, int]:
    """Write an array as raw samples that a VRT of GDAL describes. Return its path and bytes."""
    heights = arrays._real_numbers(heights, "heights")
    if heights.ndim != 2:
        is_photo = heights.ndim == 3 and heights.shape[2] in (3, 4)
        hint = "; use a file of a photo as imagery" if is_photo else ""
        raise ValueError(f"heights must be a 2-D array, not of shape {heights.shape}{hint}")
    rows, columns = heights.shape
    if rows < 2 or columns < 2:
        raise ValueError(f"heights must be at least 2 x 2, not {rows} x {columns}")
    if heights.dtype.name not in _TYPES:
        heights = heights.astype(numpy.int16 if heights.dtype.itemsize == 1 else numpy.float64)
    heights.tofile(folder / "samples")
    size = heights.dtype.itemsize
    location = ""
    if bounds is not None:
        west, east, south, north = _check_bounds(bounds)
        steps = (east - west) / columns, (south - north) / rows
        numbers = f"{west!r}, {steps[0]!r}, 0, {north!r}, 0, {steps[1]!r}"
        location = f"<GeoTransform>{numbers}</GeoTransform>"
    if crs is not None:
        location += f"<SRS>{html.escape(_make_crs_text(crs), quote=False)}</SRS>"
    missing = "" if no_data is None else f"<NoDataValue>{float(no_data)!r}</NoDataValue>"
    path = folder / "heights.vrt"
    path.write_text(
        f'<VRTDataset rasterXSize="{columns}" rasterYSize="{rows}">{location}'
        f'<VRTRasterBand dataType="{_TYPES[heights.dtype.name]}" band="1"'
        ' subClass="VRTRawRasterBand"><SourceFilename relativetoVRT="1">samples</SourceFilename>'
        f"<PixelOffset>{size}</PixelOffset><LineOffset>{size * columns}</LineOffset>"
        f"<ByteOrder>{'LSB' if sys.byteorder == 'little' else 'MSB'}</ByteOrder>"
        f"{missing}</VRTRasterBand></VRTDataset>"
    )
    return str(path), heights.nbytes


def _find_edges(centres: ArrayLike, name: str) -> tuple[tuple[float, float], bool]:
    """Return the borders of the samples of an axis of xarray, and whether it decreases."""
    centres = numpy.asarray(centres, float)
    if len(centres) < 2:
        raise ValueError(f"the coordinate {name!r} must have at least two values")
    steps = numpy.diff(centres)
    step = (centres[-1] - centres[0]) / (len(centres) - 1)
    if not numpy.allclose(steps, step, rtol=1e-3, atol=0) or step == 0:
        raise ValueError(f"the coordinate {name!r} must have equal steps")
    first, last = centres[0] - 0.5 * step, centres[-1] + 0.5 * step
    return (min(first, last), max(first, last)), step < 0


def _take_xarray(source: Any) -> tuple[NDArray[Any], Bounds | None, Any]:
    """Return heights, bounds and crs of a DataArray."""
    if callable(source.values):
        raise TypeError("heights must be a DataArray, such as dataset['elevation'], not a Dataset")
    source = source.squeeze(drop=True)
    if len(source.dims) != 2:
        raise ValueError(f"heights must have two dimensions, not {source.dims}")
    heights = source.values
    bounds = None
    if all(name in source.coords for name in source.dims):
        (south_north, southwards), (west_east, westwards) = (
            _find_edges(source.coords[name].values, name) for name in source.dims
        )
        heights = heights if southwards else heights[::-1]
        heights = heights[:, ::-1] if westwards else heights
        bounds = (*west_east, *south_north)
    spatial = getattr(source, "rio", None)
    crs = spatial.crs if spatial is not None else getattr(source, "attrs", {}).get("crs")
    return heights, bounds, crs


def _take_rasterio(source: Any) -> tuple[NDArray[Any], Bounds, Any]:
    """Return heights, bounds and crs of an open dataset that is not a file."""
    west, south, east, north = source.bounds
    return source.read(1, masked=True), (west, east, south, north), source.crs


class RasterFile:
    """A raster as the name of a file.

    source: a path, or another name that GDAL knows, a 2-D array, a DataArray of xarray, or an open
        dataset of rasterio.
    bounds: (west, east, south, north) of arrays, from border to border of the outermost samples.
    crs: the coordinate system of bounds.
    no_data: the height of samples without data, of arrays.
    """

    def __init__(
        self,
        source: Any,
        bounds: Bounds | None = None,
        crs: Any = None,
        no_data: float | None = None,
    ) -> None:
        self.name = ""
        self.size = 0  # bytes of an array
        self.title = "the array"
        # For messages, see Messages.
        self.names = {"set it as ImageryFileName": "use it as imagery of relevo.terrain()"}
        self._remove = None
        package = get_package(source)
        if package == "rasterio" and os.path.exists(source.name):
            source = source.name
        if isinstance(source, (str, os.PathLike)):
            if bounds is not None or crs is not None or no_data is not None:
                raise ValueError("bounds, crs and no_data are for arrays; a file has its own")
            self.name = self.title = os.fspath(source)
            return
        if package == "xarray":
            source, own_bounds, own_crs = _take_xarray(source)
        elif package == "rasterio":
            source, own_bounds, own_crs = _take_rasterio(source)
        else:
            own_bounds, own_crs = None, None
        bounds = own_bounds if bounds is None else bounds
        crs = own_crs if crs is None else crs
        if crs is not None and bounds is None:
            raise ValueError(f"crs needs bounds: {_ORDER}")
        if no_data is not None:
            check_number(no_data, "no_data")
        folder = tempfile.mkdtemp(prefix="relevo-", dir=_find_folder())
        self._remove = weakref.finalize(self, shutil.rmtree, folder, ignore_errors=True)
        self.name, self.size = _write(source, bounds, crs, no_data, pathlib.Path(folder))
        self.names |= {
            f"Cannot open {self.name}": f"Cannot use {self.title}",
            self.name: self.title,
            "give it the right one (gdal_translate -a_srs)": f"check crs, and bounds: {_ORDER}",
            "gdal_translate -a_srs EPSG:4326": "crs='EPSG:4326'",
            "gdal_translate -a_srs": "crs",
            "gdal_translate -a_nodata ": "no_data=",
        }

    @property
    def is_array(self) -> bool:
        return self._remove is not None

    def keep_for(self, item: vtkObject) -> None:
        """Keep the file until a VTK object is deleted."""
        item.AddObserver("DeleteEvent", lambda caller, event: self._remove and self._remove())
