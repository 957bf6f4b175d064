using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Exports.Maps;

/// <summary>What a nuScenes map shows.</summary>
/// <param name="Lanes">The lanes, those of a road or junction one after another.</param>
internal sealed record ExpansionContent(IReadOnlyList<ExpansionLane> Lanes)
{
    /// <summary>Nothing is known to be painted.</summary>
    private const string Unpainted = "NIL";

    /// <summary>The stop lines.</summary>
    public IReadOnlyList<ExpansionStopLine> StopLines { get; init; } = [];

    /// <summary>The lights and signs that govern lanes.</summary>
    public IReadOnlyList<ExpansionSignal> Signals { get; init; } = [];

    /// <summary>The pedestrian crossings.</summary>
    public IReadOnlyList<ExpansionCrossing> Crossings { get; init; } = [];

    /// <summary>What a map shows.</summary>
    public static ExpansionContent Of(LaneNetwork map)
    {
        var borders = new LaneBorders(map);
        Dictionary<int, RoadSegment> roads = map.Segments.ToDictionary(segment => segment.Link);
        string RoadOf(MapLane lane) => lane.Junction is { } junction ? map.Junctions[junction].Id : roads[lane.Link!.Value].Id;
        HermiteCurve LineOf(MapLane lane)
        {
            if (lane.Line is { } way)
            {
                return way;
            }

            HermiteCurve line = roads[lane.Link!.Value].Line;
            return lane.IsForward ? line : line.Reversed();
        }

        IReadOnlyList<Vector2D> PointsOf(BorderSide side) =>
            [.. side.Nodes.Select(node => new Vector2D(borders.Nodes[node].X, borders.Nodes[node].Y))];

        ExpansionLane[] lanes =
        [
            .. map
                .Lanes.Where(lane => !borders.LeftOut.Contains(lane))
                .Select(lane =>
                {
                    (BorderSide left, BorderSide right) = (borders.LeftOf(lane), borders.RightOf(lane));
                    return new ExpansionLane(
                        lane.Id,
                        RoadOf(lane),
                        lane.Junction is not null,
                        lane.IsForward,
                        lane.Index,
                        PointsOf(left),
                        PointsOf(right),
                        TypeOf(left.Border.Marking),
                        TypeOf(right.Border.Marking),
                        left.Border.Kind == LaneBorderKind.Centre,
                        () => LaneArcs.Of(lane, LineOf(lane)),
                        [.. borders.Before(lane).Select(other => other.Id)],
                        [.. borders.After(lane).Select(other => other.Id)]
                    );
                }),
        ];
        return new ExpansionContent(lanes)
        {
            StopLines = [.. map.StopLines.Where(line => line.Lanes.Count > 0).Select(ExpansionStopLine.Of)],
            Signals = [.. map.Signals.Where(signal => signal.Lanes.Count > 0).Select(ExpansionSignal.Of)],
            Crossings =
            [
                .. map.Crossings.Select(crossing =>
                {
                    Vector3D middle = crossing.Corners.Aggregate((sum, corner) => sum + corner) * (1.0 / crossing.Corners.Count);
                    return new ExpansionCrossing(
                        crossing.Id,
                        [.. crossing.Corners.Select(corner => new Vector2D(corner.X, corner.Y))],
                        map.Index.Near(middle, 0) is [MapLane lane, ..] ? RoadOf(lane) : ""
                    );
                }),
            ],
        };
    }

    /// <summary>The nearest of nuScenes' names, which has neither a single dashed line nor a double yellow one.</summary>
    private static string TypeOf(MapMarking? marking) =>
        marking is null ? Unpainted
        : marking.Paint.Style == MarkingStyle.Dashed ? "DOUBLE_DASHED_WHITE"
        : marking.Paint.Colour == MarkingColour.Yellow ? "SINGLE_SOLID_YELLOW"
        : marking.Paint.Style == MarkingStyle.DoubleSolid ? "DOUBLE_SOLID_WHITE"
        : "SINGLE_SOLID_WHITE";
}
