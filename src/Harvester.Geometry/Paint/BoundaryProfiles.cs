namespace Harvester.Geometry.Paint;

/// <summary>
/// The boundaries of the lanes of one direction along a road: at any station, those between two near places are on the straight line
/// between them; others are carried from the nearest places before and behind.
/// </summary>
/// <param name="places">The places of each boundary from left to right, by their stations.</param>
internal sealed class BoundaryProfiles(IReadOnlyList<List<BoundaryPlace>> places)
{
    /// <summary>How far along a road a boundary is taken for unchanged, metres.</summary>
    public const double MaxDistance = 150;

    /// <summary>A boundary was seen between places at most this far apart, metres: one place may be missing.</summary>
    private const double MaxGap = 2 * LinkBoundaries.Step;

    /// <summary>
    /// Boundaries seen at two stations move in the same way between them to within this distance, metres, or the road has changed.
    /// </summary>
    private const double MaxDifference = 0.25;

    /// <summary>
    /// Largest common movement of the boundaries, metres: nodes are stored to 0.25 m, and lines need not follow the curves between them.
    /// </summary>
    private const double MaxMoved = 1.25;

    /// <summary>The offset of each boundary at a station; null for those that are not known.</summary>
    public double?[] At(double station)
    {
        double?[] seen = SeenAt(station);
        var found = new double?[seen.Length];
        for (int i = 0; i < seen.Length; i++)
        {
            found[i] = seen[i] ?? Carried(i, station, seen);
        }

        return found;
    }

    private double?[] SeenAt(double station) => [.. Enumerable.Range(0, places.Count).Select(i => SeenAt(i, station))];

    private double? SeenAt(int boundary, double station)
    {
        (BoundaryPlace? before, BoundaryPlace? after) = Around(boundary, station);
        return before is { } a && after is { } b && b.Station - a.Station <= MaxGap ? Between(a, b, station) : null;
    }

    /// <summary>
    /// A boundary that was not seen at a station, from the nearest places where it was seen: its offset there, moved as the boundaries that
    /// were seen at both stations; between two places, the nearer counts more.
    /// </summary>
    private double? Carried(int boundary, double station, double?[] seen)
    {
        (BoundaryPlace? before, BoundaryPlace? after) = Around(boundary, station);
        BoundaryPlace? a = Moved(before, station, seen);
        BoundaryPlace? b = Moved(after, station, seen);
        return a is { } from && b is { } to ? Between(from, to, station) : a?.Offset ?? b?.Offset;
    }

    /// <summary>
    /// The place with the offset that it would have at a station: o + m, with m the mean of o_j(station) - o_j(place) over the boundaries j
    /// that were seen at both, 0 if there are none; null if it is too far away or the road changes between.
    /// </summary>
    private BoundaryPlace? Moved(BoundaryPlace? place, double station, double?[] seen)
    {
        if (place is not { } known || Math.Abs(known.Station - station) > MaxDistance)
        {
            return null;
        }

        double[] moves = [.. SeenAt(known.Station).Zip(seen, static (there, here) => here - there).OfType<double>()];
        if (moves.Length == 0)
        {
            return known;
        }

        double moved = moves.Average();
        return moves.Max() - moves.Min() <= MaxDifference && Math.Abs(moved) <= MaxMoved
            ? new BoundaryPlace(known.Station, known.Offset + moved)
            : null;
    }

    private (BoundaryPlace? Before, BoundaryPlace? After) Around(int boundary, double station)
    {
        List<BoundaryPlace> line = places[boundary];
        int after = line.FindIndex(place => place.Station >= station);
        int before = after < 0 ? line.Count - 1 : after - 1;
        return (before >= 0 ? line[before] : null, after >= 0 ? line[after] : null);
    }

    private static double Between(BoundaryPlace a, BoundaryPlace b, double station) =>
        b.Station > a.Station ? a.Offset + ((b.Offset - a.Offset) * (station - a.Station) / (b.Station - a.Station)) : a.Offset;
}
