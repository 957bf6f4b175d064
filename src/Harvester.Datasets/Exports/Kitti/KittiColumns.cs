using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Exports.Kitti;

/// <summary>What must hold for the columns that both of KITTI's label files have: type, and from occluded to rotation_y.</summary>
internal static class KittiColumns
{
    private const double HalfTurn = Math.PI + RoundingRadians;

    /// <summary>Angles have four decimals; alpha is rounded, and so is what it follows from.</summary>
    private const double RoundingRadians = 0.0002;

    /// <summary>Metres have three decimals.</summary>
    private const double RoundingMetres = 0.001;

    /// <summary>Pixels have two decimals.</summary>
    private const double RoundingPixels = 0.02;

    /// <summary>
    /// The format's boxes stand upright in the camera's frame, which moves the corners of one that leans; the centre and the size stay. So the
    /// centre must lie in the 2D box, and the boxes need share no more than this of both together.
    /// </summary>
    private const double LeastOverlap = 0.25;

    /// <summary>What lies nearer is spread over the image by the projection.</summary>
    private const double NearestDepthMetres = 2;

    private static readonly string[] Types = ["Car", "Van", "Truck", "Pedestrian", "Person_sitting", "Cyclist", "Tram", "Misc", "DontCare"];

    /// <summary>What is wrong with an object; null for nothing.</summary>
    /// <param name="type">Its type.</param>
    /// <param name="n">occluded, alpha, left, top, right, bottom, height, width, length, x, y, z, rotation_y.</param>
    /// <param name="image">Size of the image; null when it cannot be read, which is said elsewhere.</param>
    /// <param name="projection">P2, row by row; null when it cannot be read, which is said elsewhere.</param>
    public static string? ProblemOf(string type, ReadOnlySpan<double> n, ImageSize? image, double[]? projection)
    {
        if (!Types.Contains(type))
        {
            return $"'{type}' is not a type of KITTI.";
        }

        if (n[0] is not (0 or 1 or 2 or 3))
        {
            return "occluded is not 0, 1, 2 or 3.";
        }

        var box = new Box2D(n[2], n[3], n[4], n[5]);
        bool isInImage = image is not { } size || (box.XMax <= size.Width - 1 && box.YMax <= size.Height - 1);
        if (!(box.XMin >= 0 && box.YMin >= 0 && box.XMin < box.XMax && box.YMin < box.YMax && isInImage))
        {
            return "its box does not lie in the image, or has no area.";
        }

        if (n[6] < 0 || n[7] < 0 || n[8] < 0)
        {
            return "its height, width or length is below 0.";
        }

        var location = new Vector3D(n[9], n[10], n[11]);
        double distance = Math.Sqrt((location.X * location.X) + (location.Z * location.Z));
        double allowed = RoundingRadians + (RoundingMetres / Math.Max(distance, RoundingMetres));
        return Math.Abs(n[1]) > HalfTurn || Math.Abs(n[12]) > HalfTurn ? "alpha or rotation_y is not an angle from -pi to pi."
            : Math.Abs(Numbers.Wrap(n[12] - Math.Atan2(location.X, location.Z) - n[1])) > allowed ? "alpha is not rotation_y less the direction of x and z."
            : projection is null || image is not { } known || IsOn(box, n, known, projection) ? null
            : "its 3D box, projected with P2, does not fall onto its 2D box.";
    }

    private static bool IsOn(Box2D box, ReadOnlySpan<double> n, ImageSize image, double[] p)
    {
        Vector3D[] corners = Corners(n);
        if (corners.Min(corner => corner.Z) < NearestDepthMetres)
        {
            return true;
        }

        Vector2D[] points = [.. corners.Select(corner => Project(corner, p))];
        Vector2D centre = Project(new Vector3D(n[9], n[10] - (n[6] / 2), n[11]), p);
        var whole = new Box2D(0, 0, image.Width - 1, image.Height - 1);
        double rounding = RoundingPixels + (p[0] * RoundingMetres / n[11]);
        bool isCentreIn = !whole.Contains(centre) || box.Contains(new Box2D(centre.X, centre.Y, centre.X, centre.Y), rounding);
        var around = new Box2D(points.Min(point => point.X), points.Min(point => point.Y), points.Max(point => point.X), points.Max(point => point.Y));
        return isCentreIn && around.Intersect(whole) is { } seen && box.IntersectionOverUnion(seen) >= LeastOverlap;
    }

    private static Vector2D Project(Vector3D point, double[] p) => new(
        ((p[0] * point.X) + (p[2] * point.Z) + p[3]) / (point.Z + p[11]), ((p[5] * point.Y) + (p[6] * point.Z) + p[7]) / (point.Z + p[11]));

    /// <summary>The corners of the upright box, as the development kit has them: length along x, height against y, width along z, before the turn.</summary>
    private static Vector3D[] Corners(ReadOnlySpan<double> n)
    {
        (double height, double width, double length) = (n[6], n[7], n[8]);
        (double x, double y, double z) = (n[9], n[10], n[11]);
        (double sin, double cos) = Math.SinCos(n[12]);
        var corners = new List<Vector3D>();
        foreach (double along in (double[])[-length / 2, length / 2])
        {
            foreach (double across in (double[])[-width / 2, width / 2])
            {
                corners.Add(new Vector3D((cos * along) + (sin * across) + x, y, (cos * across) - (sin * along) + z));
                corners.Add(new Vector3D((cos * along) + (sin * across) + x, y - height, (cos * across) - (sin * along) + z));
            }
        }

        return [.. corners];
    }
}
