# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Places cameras and lights by directions, as relevo-view does."""

from __future__ import annotations

import numpy
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

from ._typing import Array

_FILLED = 0.94  # share of the picture's sides

# The unit vectors to the east, to the north and upwards, for each vertical axis.
AXES = (
    numpy.array([(0, 1, 0), (0, 0, 1), (1, 0, 0)]),
    numpy.array([(1, 0, 0), (0, 0, -1), (0, 1, 0)]),
    numpy.array([(1, 0, 0), (0, 1, 0), (0, 0, 1)]),
)


def find_axis(up: str) -> int:
    """Return the index of the vertical axis, "x", "y" or "z"."""
    if str(up).lower() not in ("x", "y", "z"):
        raise ValueError(f"up must be 'x', 'y' or 'z', not {up!r}")
    return "xyz".index(up.lower())


def get_vector(azimuth: float, elevation: float, axes: Array) -> Array:
    """Return the unit vector to an azimuth and an elevation, in degrees.

    axes: the unit vectors to the east, to the north and upwards, such as AXES[1].
    """
    a, e = numpy.radians(azimuth), numpy.radians(elevation)
    vector = numpy.sin(a) * numpy.cos(e), numpy.cos(a) * numpy.cos(e), numpy.sin(e)
    return numpy.array(vector) @ axes


def add_light(
    renderer: vtkRenderer, azimuth: float, elevation: float, intensity: float, axes: Array
) -> None:
    """Add a light that shines from a direction, see get_vector()."""
    light = vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(get_vector(azimuth, elevation, axes))
    light.SetFocalPoint(0, 0, 0)
    light.SetIntensity(intensity)
    renderer.AddLight(light)


def _find_eye(points: Array, window: tuple[float, float, float, float]) -> Array:
    """Return the nearest eye from which all points are in a window at distance 1."""
    eye = numpy.zeros(3)
    depths = []
    sides = []
    for axis in range(2):
        low, high = window[2 * axis : 2 * axis + 2]
        middle, half = 0.5 * (low + high), 0.5 * _FILLED * (high - low)
        # |x - X - middle (z - Z)| <= half (z - Z) for points (x, z) and the eye (X, Z).
        upper = (points[:, axis] - (middle + half) * points[:, 2]).max()
        lower = ((middle - half) * points[:, 2] - points[:, axis]).max()
        depths.append((upper + lower) / half)
        sides.append((0.5 * (upper - lower), middle))
    eye[2] = -0.5 * max(depths)
    for axis, (offset, middle) in enumerate(sides):
        eye[axis] = offset + middle * eye[2]
    return eye


def _is_out_of_corner(points: Array, eye: Array, x: float, y: float) -> bool:
    """Return whether a line through (x, y) separates points from the upper left corner.

    x, y: in the plane at distance 1 from the eye.
    """
    depth = points[:, 2] - eye[2]
    offsets = points[:, :2] - eye[:2] - numpy.outer(depth, (x, y))
    angles = numpy.linspace(0, 0.5 * numpy.pi, 31)
    normals = numpy.stack([-numpy.cos(angles), numpy.sin(angles)])
    return bool((offsets @ normals <= 0).all(axis=0).any())


def fit_camera(
    renderer: vtkRenderer,
    points: Array,
    direction: tuple[float, float],
    axes: Array,
    size: tuple[int, int],
    corner: tuple[int, int] = (0, 0),
) -> None:
    """Look from a direction (azimuth, elevation) at points, of shape (n, 3).

    axes: as for get_vector(). size: columns and rows of the picture. corner: columns and rows at the upper left that stay
        free, for a colour bar.
    """
    points = numpy.asarray(points, float)
    points = points[numpy.isfinite(points).all(axis=1)]
    if not len(points):
        points = numpy.zeros((1, 3))
    azimuth, elevation = direction
    # The vertical axis must not be parallel to the view.
    forward = -get_vector(azimuth, numpy.clip(elevation, -89.9999, 89.9999), axes)
    vertical = axes[2]
    right = numpy.cross(forward, vertical)
    right /= numpy.linalg.norm(right)
    view = numpy.array([right, numpy.cross(right, forward), forward])

    camera = renderer.GetActiveCamera()
    pixel = 2.0 * numpy.tan(0.5 * numpy.radians(camera.GetViewAngle())) / size[1]
    width, height = size[0] * pixel, size[1] * pixel
    # The lower right end of the corner, relative to the picture's centre.
    x, y = corner[0] * pixel - 0.5 * width, 0.5 * height - corner[1] * pixel
    turned = points @ view.T
    eye = _find_eye(turned, (-0.5 * width, 0.5 * width, -0.5 * height, 0.5 * height))
    if any(corner) and not _is_out_of_corner(turned, eye, x, y):
        eye = _find_eye(turned, (x, 0.5 * width, -0.5 * height, 0.5 * height))
        if y > -0.5 * height:
            below = _find_eye(turned, (-0.5 * width, 0.5 * width, -0.5 * height, y))
            eye = below if below[2] > eye[2] else eye
    centre = 0.5 * (points.min(axis=0) + points.max(axis=0))
    distance = centre @ forward - eye[2]
    if distance <= 0:  # all points coincide
        distance = 1.0
    position = eye @ view
    camera.SetPosition(position)
    camera.SetFocalPoint(position + distance * forward)
    camera.SetViewUp(vertical)
    renderer.ResetCameraClippingRange()
