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
/// <param name="MakeArcs">Makes the arcs of its middle: those of all lanes of a network would take much memory.</param>
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
    Func<IReadOnlyList<LaneArc>> MakeArcs,
    IReadOnlyList<string> Predecessors,
    IReadOnlyList<string> Successors
)
{
    /// <summary>The name of the lanes of its direction on its road.</summary>
    public string Block => BlockOf(Road, IsForward);

    private const int ArcDecimals = 9;
    private const int NumbersOfArc = 5;

    /// <summary>Reads what <see cref="ToString"/> wrote.</summary>
    public static ExpansionLane Parse(string text)
    {
        string[] fields = text.Split(ExpansionText.Field);
        double[] flags = ExpansionText.Values(fields[2]);
        return new ExpansionLane(
            fields[0],
            fields[1],
            flags[0] > 0,
            flags[1] > 0,
            (int)flags[2],
            ExpansionText.Points(fields[3]),
            ExpansionText.Points(fields[4]),
            fields[5],
            fields[6],
            flags[3] > 0,
            () =>
                [.. ExpansionText.Values(fields[7]).Chunk(NumbersOfArc).Select(arc => new LaneArc(arc[0], arc[1], arc[2], arc[3], arc[4]))],
            ExpansionText.Names(fields[8]),
            ExpansionText.Names(fields[9])
        );
    }

    /// <summary>The lane as a line of text without semicolons.</summary>
    public override string ToString() =>
        string.Join(
            ExpansionText.Field,
            Id,
            Road,
            Numbers.Row(0, IsConnector ? 1 : 0, IsForward ? 1 : 0, Index, TouchesOncoming ? 1 : 0),
            ExpansionText.Of(Left),
            ExpansionText.Of(Right),
            LeftType,
            RightType,
            Numbers.Row(ArcDecimals, [.. MakeArcs().SelectMany(arc => (double[])[arc.X, arc.Y, arc.Heading, arc.Curvature, arc.Length])]),
            ExpansionText.Of(Predecessors),
            ExpansionText.Of(Successors)
        );

    /// <summary>The name of the lanes of a direction on a road.</summary>
    public static string BlockOf(string road, bool isForward) => $"{road}/{(isForward ? 'f' : 'b')}";
}
