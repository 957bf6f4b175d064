using System;
using System.Linq;
using Harvester.Datasets.Json;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Exports.Lanes;

/// <summary>What must hold for one lane line of OpenLane.</summary>
internal static class OpenLaneLine
{
    /// <summary>
    /// The format says nothing of a lens, and pixels are with its bend: a strong one moves a point at the image's edge by a tenth of the width.
    /// </summary>
    private const double MostBendFraction = 0.1;

    private const double RoundingPixels = 0.002;
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

        if (line.WholeNumber("attribute") is < 0 or > LastAttribute || line.WholeNumber("category") < 0 || !line.Has("track_id"))
        {
            return "its attribute, category or track_id is not one of the format's.";
        }

        return Enumerable.Range(0, visibility.Length).Select(i => PointProblem(i, uv, xyz, intrinsic, image)).FirstOrDefault(problem => problem is not null);
    }

    private static string? PointProblem(int i, double[][] uv, double[][] xyz, double[][] k, ImageSize image)
    {
        (double u, double v) = (uv[0][i], uv[1][i]);
        (double forward, double left, double up) = (xyz[0][i], xyz[1][i], xyz[2][i]);
        if (!(u >= -RoundingPixels && v >= -RoundingPixels && u <= image.Width + RoundingPixels && v <= image.Height + RoundingPixels))
        {
            return $"point {i} does not lie in the image of {image.Width} x {image.Height}.";
        }

        double allowed = MostBendFraction * image.Width;
        return forward > 0
            && Math.Abs((k[0][0] * -left / forward) + k[0][2] - u) <= allowed
            && Math.Abs((k[1][1] * -up / forward) + k[1][2] - v) <= allowed ? null : $"point {i}, projected with intrinsic, does not fall onto its pixel.";
    }
}
