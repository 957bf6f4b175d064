using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>A lane, or a way through a junction, of a nuScenes map. Metres on the ground, world.</summary>
/// <param name="Id">Its name.</param>
/// <param name="Road">The name of its road or junction.</param>
/// <param name="IsConnector">Whether it leads through a junction.</param>
/// <param name="IsForward">Whether it runs as its road's line.</param>
/// <param name="Index">Its number in its direction, 0 the leftmost.</param>
/// <param name="Left">Points of its left border, in its direction.</param>
/// <param name="Right">Points of its right border.</param>
/// <param name="LeftType">How its left border is painted, as nuScenes calls it.</param>
/// <param name="RightType">How its right border is painted.</param>
/// <param name="TouchesOncoming">Whether its left border is that of the oncoming lane too.</param>
/// <param name="Arcs">Its middle.</param>
/// <param name="Predecessors">The names of the lanes before it.</param>
/// <param name="Successors">The names of the lanes after it.</param>
internal sealed record ExpansionLane(
    string Id,
    string Road,
    bool IsConnector,
    bool IsForward,
    int Index,
    IReadOnlyList<Vector2D> Left,
    IReadOnlyList<Vector2D> Right,
    string LeftType,
    string RightType,
    bool TouchesOncoming,
    IReadOnlyList<LaneArc> Arcs,
    IReadOnlyList<string> Predecessors,
    IReadOnlyList<string> Successors
)
{
    /// <summary>The name of the lanes of its direction on its road.</summary>
    public string Block => BlockOf(Road, IsForward);

    private const char Field = '|';
    private const char Item = ',';
    private const int MetreDecimals = 3;
    private const int ArcDecimals = 9;
    private const int NumbersOfArc = 5;

    /// <summary>Reads what <see cref="ToString"/> wrote.</summary>
    public static ExpansionLane Parse(string text)
    {
        string[] fields = text.Split(Field);
        double[] flags = NumbersOf(fields[2]);
        return new ExpansionLane(
            fields[0],
            fields[1],
            flags[0] > 0,
            flags[1] > 0,
            (int)flags[2],
            [.. NumbersOf(fields[3]).Chunk(2).Select(point => new Vector2D(point[0], point[1]))],
            [.. NumbersOf(fields[4]).Chunk(2).Select(point => new Vector2D(point[0], point[1]))],
            fields[5],
            fields[6],
            flags[3] > 0,
            [.. NumbersOf(fields[7]).Chunk(NumbersOfArc).Select(arc => new LaneArc(arc[0], arc[1], arc[2], arc[3], arc[4]))],
            NamesOf(fields[8]),
            NamesOf(fields[9])
        );
    }

    /// <summary>The lane as a line of text without semicolons.</summary>
    public override string ToString() =>
        string.Join(
            Field,
            Id,
            Road,
            Numbers.Row(0, IsConnector ? 1 : 0, IsForward ? 1 : 0, Index, TouchesOncoming ? 1 : 0),
            TextOf(Left),
            TextOf(Right),
            LeftType,
            RightType,
            Numbers.Row(ArcDecimals, [.. Arcs.SelectMany(arc => (double[])[arc.X, arc.Y, arc.Heading, arc.Curvature, arc.Length])]),
            string.Join(Item, Predecessors),
            string.Join(Item, Successors)
        );

    private static string TextOf(IReadOnlyList<Vector2D> points) =>
        Numbers.Row(MetreDecimals, [.. points.SelectMany(point => (double[])[point.X, point.Y])]);

    private static double[] NumbersOf(string text) => text.Length == 0 ? [] : Numbers.Parse(text.Split(' '))!;

    private static string[] NamesOf(string text) => text.Length == 0 ? [] : text.Split(Item);

    /// <summary>The name of the lanes of a direction on a road.</summary>
    public static string BlockOf(string road, bool isForward) => $"{road}/{(isForward ? 'f' : 'b')}";
}
