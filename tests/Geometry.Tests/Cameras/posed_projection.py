"""Writes posed-projection.csv: python3 posed_projection.py > posed-projection.csv. Needs python3-mpmath.

Independent of the library and of the Python package: 50 digits, homogeneous 4x4 matrices of the game's Euler angles (R = Rz Rx Ry), and
the fold of the lens found by stepping and bisection of the derivative. The inputs have few digits, so that they are exact in the file;
axes and results are rounded to 17 significant digits.
"""

import csv
import random
import sys

from mpmath import mp, mpf, matrix, cos, sin, tan, radians, sqrt, diff

mp.dps = 50
MIN_SLOPE = mpf("0.1")
NEAR = mpf("0.15")
COLUMNS = (
    "case,positionX,positionY,positionZ,rightX,rightY,rightZ,forwardX,forwardY,forwardZ,upX,upY,upZ,fovDegrees,width,height,windowAspect,focalScale,"
    "centreX,centreY,k1,k2,pointX,pointY,pointZ,u,v,depth,outcome"
).split(",")


def rotation(axis, degrees):
    """A rotation about a coordinate axis as a 4x4 matrix."""
    c, s, m = cos(radians(degrees)), sin(radians(degrees)), mp.eye(4)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    m[i, i], m[i, j], m[j, i], m[j, j] = c, -s, s, c
    return m


def fold(k1, k2):
    """The first radius where the slope of the polynomial is MIN_SLOPE; None if it stays above up to a radius of 1000."""
    slope = lambda r: diff(lambda q: q * (1 + k1 * q**2 + k2 * q**4), r) - MIN_SLOPE
    step, low = mpf("0.01"), mpf(0)
    for _ in range(100_000 if k1 < 0 or k2 < 0 else 0):
        if slope(low + step) < 0:
            high = low + step
            for _ in range(160):
                middle = (low + high) / 2
                low, high = (low, middle) if slope(middle) < 0 else (middle, high)
            return low
        low += step
        if low > 8 and k2 >= 0:
            break
    return None


def distorted(radius, k1, k2):
    shown = lambda r: r * (1 + k1 * r**2 + k2 * r**4)
    end = fold(k1, k2)
    return shown(radius) if end is None or radius <= end else shown(end) + MIN_SLOPE * (radius - end)


def orthonormal(right, forward, _):
    """Axes of which forward keeps its direction; right is turned square to it, and up follows."""
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    unit = lambda a: [x / sqrt(dot(a, a)) for x in a]
    forward = unit(forward)
    right = unit([r - dot(right, forward) * f for r, f in zip(right, forward)])
    (a, b, c), (d, e, f) = right, forward
    return [right, forward, [b * f - c * e, c * d - a * f, a * e - b * d]]


def text(value):
    return mp.nstr(value, 17, strip_zeros=True, min_fixed=-20, max_fixed=20)


def main():
    draw = random.Random(24)
    number = lambda low, high, decimals: mpf(str(round(draw.uniform(low, high), decimals)))
    lenses = [
        ("pinhole", "0", "0"),
        ("barrel", "-0.08", "0.01"),
        ("cushion", "0.15", "0"),
        ("folding", "-0.35", "0"),
        ("late fold", "0.05", "-0.02"),
        ("fisheye", "-0.2", "0.05"),
    ]
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(COLUMNS)
    for name, k1, k2 in lenses:
        k1, k2 = mpf(k1), mpf(k2)
        for case in range(8):
            position = [number(-4000, 4000, 2), number(-4000, 4000, 2), number(-50, 800, 2)]
            pitch, roll, yaw = number(-30, 30, 1), number(-20, 20, 1), number(-180, 180, 1)
            pose = rotation("z", yaw) * rotation("x", pitch) * rotation("y", roll)
            for i in range(3):
                pose[i, 3] = position[i]
            # Both readers start from the axes as they are in the file.
            listed = [[mpf(text(pose[i, j])) for i in range(3)] for j in range(3)]
            if case in (4, 5):
                # As in a label, with nine decimals.
                listed = [[mp.nint(x * 10**9) / 10**9 for x in axis] for axis in listed]
            axes = orthonormal(*listed)
            world_to_camera = mp.eye(4)
            for i in range(3):
                for j in range(3):
                    world_to_camera[i, j] = axes[i][j]
                world_to_camera[i, 3] = -sum(axes[i][j] * position[j] for j in range(3))
            width, height = draw.choice([(280, 210), (800, 600), (1920, 1080)])
            fov, aspect, scale = number(30, 110, 2), number(1.2, 2.4, 3), number(0.9, 1.1, 3)
            centre_x, centre_y = number(-0.02, 0.02, 4), number(-0.02, 0.02, 4)
            # Points ahead within about 80 degrees of the axis; one in eight is behind.
            depth = number(1, 120, 2) * (-1 if case == 7 else 1)
            local = [abs(depth) * number(-1, 1, 3) * (4 if case == 6 else 1), depth, abs(depth) * number(-0.6, 0.6, 3)]
            point = [round(sum(axes[j][i] * local[j] for j in range(3)) + position[i], 6) for i in range(3)]
            seen = world_to_camera * matrix([*point, 1])
            row = [
                f"{name} {case + 1}",
                *map(text, position),
                *(text(x) for axis in listed for x in axis),
                text(fov),
                width,
                height,
                text(aspect),
                text(scale),
                text(centre_x),
                text(centre_y),
                text(k1),
                text(k2),
                *map(text, point),
            ]
            if seen[1] < NEAR:
                row += ["0", "0", text(seen[1]), "BehindNearPlane"]
            else:
                x, y = seen[0] / seen[1], -seen[2] / seen[1]
                radius = sqrt(x * x + y * y)
                factor = distorted(radius, k1, k2) / radius
                half = tan(radians(fov) / 2)
                u = width * (mpf("0.5") + centre_x) + scale * width / (2 * half * aspect) * x * factor
                v = height * (mpf("0.5") + centre_y) + scale * height / (2 * half) * y * factor
                inside = 0 <= u < width and 0 <= v < height
                row += [text(u), text(v), text(seen[1]), "InImage" if inside else "OutsideImage"]
            writer.writerow(row)


main()
