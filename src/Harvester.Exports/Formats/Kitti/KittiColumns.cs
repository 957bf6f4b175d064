using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>Checks the columns that both label formats of KITTI have: type, and from occluded to rotation_y.</summary>
/// <param name="boxes">The exported kind of boxes.</param>
internal sealed class KittiColumns(BoxKind boxes)
{
    private const double HalfTurn = Math.PI + RoundingRadians;

    /// <summary>Angles have four decimals; alpha is rounded, and so are the values it is checked against.</summary>
    private const double RoundingRadians = 0.0002;

    /// <summary>Metres have three decimals.</summary>
    private const double RoundingMetres = 0.001;

    /// <summary>Pixels have two decimals.</summary>
    private const double RoundingPixels = 0.02;

    /// <summary>The format has no lens distortion; images with more than this are refused at export.</summary>
    private const double MaxDistortionPixels = LensDistortion.MaxPixels;

    /// <summary>The projection magnifies errors of nearer objects.</summary>
    private const double MinDepthMetres = 2;

    /// <summary>
    /// Visible pixels may lie outside the cuboid by this fraction of its side, where masks of another tool were imported.
    /// </summary>
    private const double MaxOverhangFraction = 0.25;

    /// <summary>The problem of an object or region; null for none.</summary>
    /// <param name="type">The type.</param>
    /// <param name="n">occluded, alpha, left, top, right, bottom, height, width, length, x, y, z, rotation_y.</param>
    /// <param name="image">Size of the image; null if unreadable, which is reported elsewhere.</param>
    /// <param name="projection">P2 by rows; null if unreadable, which is reported elsewhere.</param>
    /// <param name="missPixels">Allowed distance between the projected upright box and the 2D box, pixels.</param>
    public string? ProblemOf(string type, ReadOnlySpan<double> n, ImageSize? image, double[]? projection, double missPixels)
    {
        if (type != KittiClasses.DontCare && !KittiClasses.Types.Contains(type))
        {
            return $"'{type}' is not a type of KITTI.";
        }

        var box = new Box2D(n[2], n[3], n[4], n[5]);
        bool isInImage = image is not { } size || (box.XMax <= size.Width - 1 && box.YMax <= size.Height - 1);
        if (!(box.XMin >= 0 && box.YMin >= 0 && box.XMin < box.XMax && box.YMin < box.YMax && isInImage))
        {
            return "its box does not lie in the image, or has no area.";
        }

        return type == KittiClasses.DontCare ? null : ObjectProblem(n, box, image, projection, missPixels);
    }

    private string? ObjectProblem(ReadOnlySpan<double> n, Box2D box, ImageSize? image, double[]? projection, double missPixels)
    {
        if (n[0] is not (0 or 1 or 2 or 3))
        {
            return "occluded is not 0, 1, 2 or 3.";
        }

        if (n[6] < 0 || n[7] < 0 || n[8] < 0)
        {
            return "its height, width or length is below 0.";
        }

        var location = new Vector3D(n[9], n[10], n[11]);
        double distance = Math.Sqrt((location.X * location.X) + (location.Z * location.Z));
        double allowed = RoundingRadians + (RoundingMetres / Math.Max(distance, RoundingMetres));
        return Math.Abs(n[1]) > HalfTurn || Math.Abs(n[12]) > HalfTurn ? "alpha or rotation_y is not an angle from -pi to pi."
            : Math.Abs(Angles.WrapRadians(n[12] - Math.Atan2(location.X, location.Z) - n[1])) > allowed
                ? "alpha is not rotation_y minus the direction of x and z."
            : projection is null || image is not { } known || IsOn(box, n, known, projection, missPixels) ? null
            : "its 3D box, projected with P2, does not fall onto its 2D box.";
    }

    /// <summary>Every 2D box lies within the projected 3D box; for cuboids that lie in the image, the two are equal.</summary>
    private bool IsOn(Box2D box, ReadOnlySpan<double> n, ImageSize image, double[] p, double missPixels)
    {
        Vector3D[] corners = KittiCorners.Of(new Vector3D(n[9], n[10], n[11]), n[6], n[7], n[8], n[12]);
        double nearest = corners.Min(corner => corner.Z);
        if (nearest < MinDepthMetres)
        {
            return true;
        }

        Vector2D[] points = [.. corners.Select(corner => Project(corner, p))];
        var around = new Box2D(
            points.Min(point => point.X),
            points.Min(point => point.Y),
            points.Max(point => point.X),
            points.Max(point => point.Y)
        );
        var whole = new Box2D(0, 0, image.Width - 1, image.Height - 1);
        if (around.Intersect(whole) is not { } seen)
        {
            return false;
        }

        double rounding = RoundingPixels + MaxDistortionPixels + missPixels + (p[0] * RoundingMetres / nearest);
        bool isOfPixels = boxes is BoxKind.Visible or BoxKind.Whole;
        double overhang = isOfPixels ? MaxOverhangFraction : 0;
        return Grown(seen, rounding + (overhang * seen.Width), rounding + (overhang * seen.Height)).Contains(box, 0)
            && (isOfPixels || !whole.Contains(around, 0) || box.Contains(seen, rounding));
    }

    private static Box2D Grown(Box2D box, double across, double down) =>
        new(box.XMin - across, box.YMin - down, box.XMax + across, box.YMax + down);

    private static Vector2D Project(Vector3D point, double[] p) =>
        new(
            ((p[0] * point.X) + (p[2] * point.Z) + p[3]) / (point.Z + p[11]),
            ((p[5] * point.Y) + (p[6] * point.Z) + p[7]) / (point.Z + p[11])
        );
}
