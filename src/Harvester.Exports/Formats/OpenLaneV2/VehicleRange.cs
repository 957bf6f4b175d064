using Harvester.Geometry;

namespace Harvester.Exports.Formats.OpenLaneV2;

/// <summary>The range of the benchmark around the vehicle, in its frame: x forward, y left, z up, metres.</summary>
internal static class VehicleRange
{
    /// <summary>How far it reaches ahead and behind.</summary>
    public const double Ahead = 50;

    /// <summary>How far it reaches to either side.</summary>
    public const double Aside = 25;

    /// <summary>World points in the vehicle's frame.</summary>
    /// <param name="points">Metres, world.</param>
    /// <param name="vehicle">Its frame, with axes right, forward and up.</param>
    public static Vector3D[] Points(IReadOnlyList<Vector3D> points, Pose vehicle) =>
        [.. points.Select(vehicle.ToLocal).Select(local => new Vector3D(local.Y, -local.X, local.Z))];

    /// <summary>
    /// Where a line is within the range: from and to as numbers of points, with fractions between them, ascending; each with a length.
    /// </summary>
    public static IEnumerable<(double From, double To)> Within(IReadOnlyList<Vector3D> line)
    {
        (double From, double To)? open = null;
        for (int i = 1; i < line.Count; i++)
        {
            (double From, double To)? part = Within(line[i - 1], line[i]);
            if (open is { } known && (part is null || part.Value.From > 0))
            {
                yield return known;
                open = null;
            }

            if (part is { } inside)
            {
                open = (open?.From ?? (i - 1 + inside.From), i - 1 + inside.To);
                if (inside.To < 1)
                {
                    yield return open.Value;
                    open = null;
                }
            }
        }

        if (open is { } last)
        {
            yield return last;
        }
    }

    /// <summary>A part of a line, from and to as <see cref="Within(IReadOnlyList{Vector3D})"/> gives them.</summary>
    public static Vector3D[] Part(IReadOnlyList<Vector3D> line, double from, double to)
    {
        int first = (int)Math.Floor(from) + 1;
        int beyond = (int)Math.Ceiling(to);
        return [At(line, from), .. Enumerable.Range(first, Math.Max(0, beyond - first)).Select(i => line[i]), At(line, to)];
    }

    /// <summary>Length on the ground, metres.</summary>
    public static double LengthOf(IReadOnlyList<Vector3D> line) =>
        line.Skip(1).Zip(line, (point, before) => new Vector2D(point.X - before.X, point.Y - before.Y).Length).Sum();

    private static Vector3D At(IReadOnlyList<Vector3D> line, double place)
    {
        int i = Math.Min((int)Math.Floor(place), line.Count - 2);
        return line[i] + ((line[i + 1] - line[i]) * (place - i));
    }

    /// <summary>The part of a piece in the range, as fractions of it; null if there is none (Liang-Barsky clipping).</summary>
    private static (double From, double To)? Within(Vector3D start, Vector3D end)
    {
        (double from, double to) = (0, 1);
        Vector3D along = end - start;
        foreach (
            (double slope, double room) in ((double, double)[])
                [(-along.X, start.X + Ahead), (along.X, Ahead - start.X), (-along.Y, start.Y + Aside), (along.Y, Aside - start.Y)]
        )
        {
            if (slope == 0 ? room < 0 : slope < 0 && room / slope > to || slope > 0 && room / slope < from)
            {
                return null;
            }

            (from, to) =
                slope < 0 ? (Math.Max(from, room / slope), to)
                : slope > 0 ? (from, Math.Min(to, room / slope))
                : (from, to);
        }

        return from < to ? (from, to) : null;
    }
}
