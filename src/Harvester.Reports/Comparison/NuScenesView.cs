using Harvester.Geometry;

namespace Harvester.Reports.Comparison;

/// <summary>A camera of nuScenes at one moment.</summary>
/// <param name="World">The vehicle in the world.</param>
/// <param name="Mount">The camera in the vehicle: x right, y down, z forward.</param>
/// <param name="Fx">Focal length along x, pixels.</param>
/// <param name="Fy">Focal length along y, pixels.</param>
/// <param name="Cx">Principal point, pixels.</param>
/// <param name="Cy">Principal point, pixels.</param>
/// <param name="Width">Width of the image, pixels.</param>
/// <param name="Height">Height of the image, pixels.</param>
internal sealed record NuScenesView(RigidFrame World, RigidFrame Mount, double Fx, double Fy, double Cx, double Cy, int Width, int Height)
{
    private const int Corners = 8;

    /// <summary>Edges of boxes are cut at this depth.</summary>
    private const double NearMetres = 0.1;

    /// <summary>A box as this camera sees it; null if no part of it is in the image.</summary>
    /// <param name="name">Name of its class.</param>
    /// <param name="level">Its level of visibility.</param>
    /// <param name="box">The box in the world: x forward, y left, z up.</param>
    /// <param name="size">Width, length and height, metres.</param>
    public ComparedObject? See(string name, string level, RigidFrame box, ReadOnlySpan<double> size)
    {
        (double width, double length, double height) = (size[0], size[1], size[2]);
        Vector3D[] corners =
        [
            .. Enumerable
                .Range(0, Corners)
                .Select(corner =>
                    InCamera(
                        box.ToOuter(
                            new Vector3D(
                                (corner & 1) == 0 ? -length / 2 : length / 2,
                                (corner & 2) == 0 ? -width / 2 : width / 2,
                                (corner & 4) == 0 ? -height / 2 : height / 2
                            )
                        )
                    )
                ),
        ];
        Vector2D[] pixels =
        [
            .. Visible(corners).Select(point => new Vector2D(Cx + (Fx * point.X / point.Z), Cy + (Fy * point.Y / point.Z))),
        ];
        if (pixels.Length == 0)
        {
            return null;
        }

        var around = new Box2D(
            pixels.Min(pixel => pixel.X),
            pixels.Min(pixel => pixel.Y),
            pixels.Max(pixel => pixel.X),
            pixels.Max(pixel => pixel.Y)
        );
        if (around.Intersect(new Box2D(0, 0, Width, Height)) is not { } seen)
        {
            return null;
        }

        Vector3D centre = InCamera(box.ToOuter(default));
        Vector3D forward = InCamera(box.ToOuter(new Vector3D(1, 0, 0))) - centre;
        return new ComparedObject(
            name,
            null,
            seen,
            centre.Length,
            1 - (seen.Area / around.Area),
            null,
            level,
            Math.Atan2(0 - forward.Z, forward.X) - Math.Atan2(centre.X, centre.Z)
        );
    }

    private Vector3D InCamera(Vector3D point) => Mount.ToInner(World.ToInner(point));

    /// <summary>The ends of the edges in front of the camera; an edge that passes the near plane ends there.</summary>
    private static IEnumerable<Vector3D> Visible(Vector3D[] corners)
    {
        for (int corner = 0; corner < Corners; corner++)
        {
            if (corners[corner].Z >= NearMetres)
            {
                yield return corners[corner];
            }

            for (int axis = 1; axis < Corners; axis <<= 1)
            {
                (Vector3D start, Vector3D end) = (corners[corner], corners[corner ^ axis]);
                if (start.Z < NearMetres && end.Z >= NearMetres)
                {
                    yield return start + ((end - start) * ((NearMetres - start.Z) / (end.Z - start.Z)));
                }
            }
        }
    }
}
