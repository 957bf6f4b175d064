"""The camera of an image: projection of world points with the lens, and its inverse.

Frames, units and formulas are those of docs/conventions.md. The world is in metres: x east, y north, z up. Pixels are continuous with
the origin at the upper left corner of the image; the centre of the first pixel is at (0.5, 0.5).
"""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from .checks import Vector, integer, number, positive, vector
from .picture_header import MAX_SIDE

Array = npt.NDArray[np.float64]

# From the radius where its slope falls to this value, the polynomial of the lens is continued as a straight line.
_MIN_SLOPE = 0.1
# Far beyond the image, where r^5 dominates, a step divides the error by 1.25 only.
_NEWTON_STEPS = 200


def orthonormal(right: Vector, forward: Vector) -> Array:
    """Axes as the rows right, forward, up of a matrix. Labels round them; as in the C# library, forward keeps its direction, right is
    turned square to it, and up follows.
    """
    ahead = np.array(forward, dtype=np.float64)
    ahead /= np.linalg.norm(ahead)
    side = np.array(right, dtype=np.float64)
    side -= np.dot(side, ahead) * ahead
    side /= np.linalg.norm(side)
    return np.array([side, ahead, np.cross(side, ahead)])


def _end_of_polynomial(k1: float, k2: float) -> float:
    """The smallest radius where the slope 1 + 3 k1 r^2 + 5 k2 r^4 is _MIN_SLOPE; infinity if there is none."""
    a, b, c = 5 * k2, 3 * k1, 1 - _MIN_SLOPE
    discriminant = b * b - 4 * a * c
    if discriminant < 0:
        return math.inf
    stable = -0.5 * (b + (1 if b >= 0 else -1) * math.sqrt(discriminant))
    roots = [numerator / denominator for numerator, denominator in ((c, stable), (stable, a)) if denominator != 0]
    return math.sqrt(min((root for root in roots if root > 0), default=math.inf))


def _side(value: Any) -> int:
    if not 0 < integer(value) <= MAX_SIDE:
        raise ValueError(f"a picture has sides of 1 to {MAX_SIDE} pixels, not {value}")
    return int(value)


def _field_of_view(value: Any) -> float:
    if not 0.001 <= value <= 179.999:
        raise ValueError(f"a field of view of {value!r} degrees is out of range")
    return float(value)


@dataclass(frozen=True)
class Lens:
    """Radial distortion r' = r (1 + k1 r^2 + k2 r^4) of normalised image coordinates, one-to-one everywhere."""

    k1: float = 0.0
    k2: float = 0.0

    @property
    def is_rectilinear(self) -> bool:
        """Whether straight lines stay straight."""
        return self.k1 == 0 and self.k2 == 0

    def distort(self, ideal: npt.ArrayLike) -> Array:
        """Where the lens moves ideal normalised image points; any shape (..., 2)."""
        points = np.asarray(ideal, dtype=np.float64)
        return points if self.is_rectilinear else self._scaled(points, self._distort_radius)

    def undistort(self, shown: npt.ArrayLike) -> Array:
        """The inverse of distort; any shape (..., 2)."""
        points = np.asarray(shown, dtype=np.float64)
        return points if self.is_rectilinear else self._scaled(points, self._undistort_radius)

    @staticmethod
    def _scaled(points: Array, change: Any) -> Array:
        radius = np.sqrt(np.sum(points * points, axis=-1))
        with np.errstate(invalid="ignore"):
            factor = np.where(radius == 0, 1.0, change(radius) / np.where(radius == 0, 1.0, radius))
        return np.asarray(points * factor[..., np.newaxis])

    def _polynomial(self, radius: Any) -> Any:
        q = radius * radius
        return radius * (1 + q * (self.k1 + q * self.k2))

    def _distort_radius(self, radius: Array) -> Array:
        end = _end_of_polynomial(self.k1, self.k2)
        if math.isinf(end):
            return np.asarray(self._polynomial(radius))
        return np.where(radius <= end, self._polynomial(radius), self._polynomial(end) + _MIN_SLOPE * (radius - end))

    def _undistort_radius(self, shown: Array) -> Array:
        end = _end_of_polynomial(self.k1, self.k2)
        shown_end = math.inf if math.isinf(end) else self._polynomial(end)
        inside = np.where(shown < shown_end, shown, 0.0)
        # Newton's steps, kept within the bracket [low, high] by bisection.
        low = np.zeros_like(inside)
        high = np.minimum(end, inside / _MIN_SLOPE)
        radius = np.minimum(inside, high)
        for _ in range(_NEWTON_STEPS):
            error = self._polynomial(radius) - inside
            high = np.where(error > 0, radius, high)
            low = np.where(error > 0, low, radius)
            q = radius * radius
            following = radius - error / (1 + 3 * self.k1 * q + 5 * self.k2 * q * q)
            following = np.where((following >= low) & (following <= high), following, (low + high) / 2)
            if np.array_equal(following, radius, equal_nan=True):
                break
            radius = following
        return (
            radius if math.isinf(end) else np.where(shown < shown_end, radius, end + (shown - shown_end) / _MIN_SLOPE)
        )


@dataclass(frozen=True)
class Projection:
    """The images of points of the world.

    pixels: (..., 2), u to the right and v down; NaN for points nearer than the near plane.
    depths: (...), metres along the camera's forward axis, negative behind it.
    in_image: (...), whether the pixel is within the image.
    """

    pixels: Array
    depths: Array
    in_image: npt.NDArray[np.bool_]


@dataclass(frozen=True)
class Camera:
    """A camera with pose, field of view and lens.

    position: metres, world. right, forward, up: unit vectors, world. vertical_fov_degrees and window_aspect (width / height) belong to
    the game's window, width and height (pixels) to the saved image. near_clip: metres. focal_scale: factor on both focal lengths.
    cx, cy: principal point, pixels from the left and upper edges.
    """

    position: Vector
    right: Vector
    forward: Vector
    up: Vector
    vertical_fov_degrees: float
    width: int
    height: int
    window_aspect: float
    near_clip: float
    focal_scale: float
    cx: float
    cy: float
    lens: Lens = Lens()

    @staticmethod
    def from_json(camera: Mapping[str, Any]) -> Camera:
        """The camera of a label or of session.json. Raises KeyError, TypeError or ValueError if it is invalid."""
        distortion = camera["distortion"]
        return Camera(
            vector(camera["position"]),
            vector(camera["right"]),
            vector(camera["forward"]),
            vector(camera["up"]),
            _field_of_view(camera["verticalFovDegrees"]),
            _side(camera["width"]),
            _side(camera["height"]),
            positive(camera["windowAspect"]),
            positive(camera["nearClip"]),
            positive(distortion["focalScale"]),
            number(camera["cx"]),
            number(camera["cy"]),
            Lens(number(distortion["k1"]), number(distortion["k2"])),
        )

    @property
    def fx(self) -> float:
        """Horizontal focal length of the saved image, pixels."""
        return (
            self.focal_scale
            * self.width
            / (2 * math.tan(math.radians(self.vertical_fov_degrees) / 2) * self.window_aspect)
        )

    @property
    def fy(self) -> float:
        """Vertical focal length of the saved image, pixels."""
        return self.focal_scale * self.height / (2 * math.tan(math.radians(self.vertical_fov_degrees) / 2))

    @functools.cached_property
    def axes(self) -> Array:
        """Right, forward and up as the rows of a matrix, which turns world directions into the camera's frame."""
        return orthonormal(self.right, self.forward)

    @property
    def matrix(self) -> Array:
        """OpenCV's 3x3 camera matrix. OpenCV's camera frame is x right, y down, z forward, and its pixel centres are whole numbers."""
        return np.array([[self.fx, 0, self.cx - 0.5], [0, self.fy, self.cy - 0.5], [0, 0, 1]])

    def to_camera(self, world: npt.ArrayLike) -> Array:
        """Points of the world in the camera's frame (x right, y forward, z up), metres; any shape (..., 3)."""
        return np.asarray((np.asarray(world, dtype=np.float64) - np.array(self.position)) @ self.axes.T)

    def project(self, world: npt.ArrayLike) -> Projection:
        """Projects points of the world, metres; any shape (..., 3)."""
        points = self.to_camera(world)
        depths = points[..., 1]
        behind = ~(depths >= self.near_clip)
        divisor = np.where(behind, 1.0, depths)
        shown = self.lens.distort(np.stack([points[..., 0] / divisor, -points[..., 2] / divisor], axis=-1))
        pixels = np.where(behind[..., np.newaxis], np.nan, shown * (self.fx, self.fy) + (self.cx, self.cy))
        with np.errstate(invalid="ignore"):
            in_image = np.all((pixels >= 0) & (pixels < (self.width, self.height)), axis=-1)
        return Projection(pixels, depths, np.asarray(in_image))

    def directions(self, pixels: npt.ArrayLike) -> Array:
        """The directions in the world (unit vectors) seen at pixels; any shape (..., 2), also outside the image."""
        rays = self._rays(pixels)
        return np.asarray(rays / np.linalg.norm(rays, axis=-1, keepdims=True))

    def unproject(self, pixels: npt.ArrayLike, depths: npt.ArrayLike) -> Array:
        """The points of the world (metres) at pixels and depths along the forward axis: the inverse of project.

        Raises ValueError if a depth is not positive.
        """
        along = np.asarray(depths, dtype=np.float64)
        if not np.all(along > 0):
            raise ValueError("Depths must be positive.")
        return np.asarray(self._rays(pixels) * along[..., np.newaxis] + np.array(self.position))

    def _rays(self, pixels: npt.ArrayLike) -> Array:
        """Directions whose component along the forward axis is 1."""
        shown = (np.asarray(pixels, dtype=np.float64) - (self.cx, self.cy)) / (self.fx, self.fy)
        ideal = self.lens.undistort(shown)
        local = np.stack([ideal[..., 0], np.ones(ideal.shape[:-1]), -ideal[..., 1]], axis=-1)
        return np.asarray(local @ self.axes)
