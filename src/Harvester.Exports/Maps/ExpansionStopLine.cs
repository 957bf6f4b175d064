using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>A stop line of a nuScenes map. Metres on the ground, world.</summary>
/// <param name="Id">Its name.</param>
/// <param name="Outline">The area that stands for it.</param>
/// <param name="Lanes">The names of the lanes that wait there.</param>
internal sealed record ExpansionStopLine(string Id, IReadOnlyList<Vector2D> Outline, IReadOnlyList<string> Lanes)
{
    /// <summary>Begins the text of a stop line.</summary>
    public const string Prefix = "#stop";

    /// <summary>Length of the area, metres along the road.</summary>
    private const double Depth = 0.6;

    /// <summary>A stop line of a map.</summary>
    public static ExpansionStopLine Of(MapStopLine line) =>
        Of(line.Id, line.Left, line.Right, line.Lanes[0].EndDirection, line.Lanes.Select(lane => lane.Id));

    /// <summary>The stop line where lanes end.</summary>
    /// <param name="id">Its name.</param>
    /// <param name="lanes">The lanes, from left to right.</param>
    public static ExpansionStopLine At(string id, IReadOnlyList<MapLane> lanes) =>
        Of(id, lanes[0].Left[^1], lanes[^1].Right[^1], lanes[0].EndDirection, lanes.Select(lane => lane.Id));

    /// <summary>Reads what <see cref="ToString"/> wrote.</summary>
    public static ExpansionStopLine Parse(string text)
    {
        string[] fields = text.Split(ExpansionText.Field);
        return new ExpansionStopLine(fields[1], ExpansionText.Points(fields[2]), ExpansionText.Names(fields[3]));
    }

    /// <summary>The stop line as a line of text without semicolons.</summary>
    public override string ToString() => string.Join(ExpansionText.Field, Prefix, Id, ExpansionText.Of(Outline), ExpansionText.Of(Lanes));

    private static ExpansionStopLine Of(string id, Vector3D left, Vector3D right, Vector2D ahead, IEnumerable<string> lanes)
    {
        Vector2D back = ahead * -Depth;
        var (one, other) = (new Vector2D(left.X, left.Y), new Vector2D(right.X, right.Y));
        return new ExpansionStopLine(id, [one, other, other + back, one + back], [.. lanes]);
    }
}
