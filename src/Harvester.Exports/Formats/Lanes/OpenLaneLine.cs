using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>Checks one lane line of OpenLane.</summary>
internal static class OpenLaneLine
{
    /// <summary>
    /// The format has no lens distortion, but the pixels include it: a strong lens shifts a point by a fifth of its distance from the
    /// principal point.
    /// </summary>
    private const double MaxBendFraction = 0.2;

    /// <summary>Distortion is radial in normalised coordinates, and in pixels only as far as both focal lengths are equal.</summary>
    private const double AspectFraction = 0.01;

    /// <summary>Nearer to the principal point, the radial direction is numerically undefined.</summary>
    private const double MinRadiusPixels = 0.01;

    private const double RoundingPixels = 0.002;

    /// <summary>Metres have four decimals.</summary>
    private const double RoundingMetres = 0.0001;
    private const int LastAttribute = 4;

    public static string? Problem(JsonFields line, double[][] intrinsic, ImageSize image)
    {
        double[][] uv = line.Rows("uv");
        double[][] xyz = line.Rows("xyz");
        double[] visibility = line.Numbers("visibility");
        if (uv.Length != 2 || xyz.Length != 3 || uv.Concat(xyz).Any(row => row.Length != visibility.Length))
        {
            return "uv, xyz and visibility are not of one length.";
        }

        if (visibility.Any(seen => seen is not (0 or 1)))
        {
            return "a visibility is not 0 or 1.";
        }

        if (line.Integer("attribute") is < 0 or > LastAttribute || line.Integer("category") < 0 || !line.Has("track_id"))
        {
            return "its attribute, category or track_id has an unknown value.";
        }

        return Enumerable
            .Range(0, visibility.Length)
            .Select(i => PointProblem(i, uv, xyz, intrinsic, image))
            .FirstOrDefault(problem => problem is not null);
    }

    private static string? PointProblem(int i, double[][] uv, double[][] xyz, double[][] k, ImageSize image)
    {
        (double u, double v) = (uv[0][i], uv[1][i]);
        (double forward, double left, double up) = (xyz[0][i], xyz[1][i], xyz[2][i]);
        if (!(u >= -RoundingPixels && v >= -RoundingPixels && u <= image.Width + RoundingPixels && v <= image.Height + RoundingPixels))
        {
            return $"point {i} does not lie in the image of {image.Width} x {image.Height}.";
        }

        if (!(forward > 0))
        {
            return $"point {i} lies behind the camera.";
        }

        // A lens shifts a point along the ray from the principal point and never to the other side of it.
        var ideal = new Vector2D(k[0][0] * -left / forward, k[1][1] * -up / forward);
        var seen = new Vector2D(u - k[0][2], v - k[1][2]);
        double radius = Math.Max(ideal.Length, MinRadiusPixels);
        double along = seen.Dot(ideal) / radius;
        double across = seen.Cross(ideal) / radius;
        double rounding = RoundingPixels + (k[0][0] * RoundingMetres * (1 + (radius / k[0][0])) / forward);
        return
            Math.Abs(along - ideal.Length) <= (MaxBendFraction * ideal.Length) + rounding
            && Math.Abs(across) <= (AspectFraction * ideal.Length) + rounding
            ? null
            : $"point {i}, projected with intrinsic, does not fall onto its pixel.";
    }
}
