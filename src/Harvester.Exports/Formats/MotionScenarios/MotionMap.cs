using Harvester.Datasets.Logs;
using Harvester.Exports.Formats.OpenLaneV2;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>The map around a frame: lanes, lines between them, edges of roads, crossings and the stop signs in its image.</summary>
internal static class MotionMap
{
    /// <summary>WOMD's numbers of lanes and edges.</summary>
    private const int Freeway = 1;
    private const int Street = 2;
    private const int Boundary = 1;
    private const int Median = 2;

    private const string StopSignCode = "R1-1";

    /// <summary>The features of a frame.</summary>
    public static IEnumerable<NamedFeature> Of(LaneNetwork map, FrameLabel label)
    {
        var level = new Pose(Vector3D.Zero, Axes.Identity);
        var painted = new PaintedEdges(label.Lanes?.Markings ?? [], level);
        int TypeOf(IReadOnlyList<Vector3D> edge) => TypeOfPaint(painted.PaintOf(VehicleRange.Points(edge, level)));
        foreach (MapLane lane in map.Lanes)
        {
            yield return LaneOf(map, lane);
        }

        foreach (RoadSegment road in map.Segments)
        {
            foreach (MapLane lane in road.Forward.Concat(road.Backward))
            {
                if (lane.LeftNeighbour is not null || (lane.Oncoming is not null && LineOwner(lane) == lane))
                {
                    yield return new NamedFeature(LeftLine(lane), LogFeatureKind.RoadLine, TypeOf(lane.Left), lane.Left);
                }
                else if (lane.Oncoming is null)
                {
                    int kind = road is { Forward.Count: > 0, Backward.Count: > 0 } ? Median : Boundary;
                    yield return new NamedFeature(LeftEdge(lane), LogFeatureKind.RoadEdge, kind, lane.Left);
                    if (TypeOf(lane.Left) is var left and > 0)
                    {
                        yield return new NamedFeature(LeftLine(lane), LogFeatureKind.RoadLine, left, lane.Left);
                    }
                }

                if (lane.RightNeighbour is null)
                {
                    yield return new NamedFeature(RightEdge(lane), LogFeatureKind.RoadEdge, Boundary, lane.Right);
                    if (TypeOf(lane.Right) is var right and > 0)
                    {
                        yield return new NamedFeature(RightLine(lane), LogFeatureKind.RoadLine, right, lane.Right);
                    }
                }
            }
        }

        foreach (MapCrossing crossing in map.Crossings)
        {
            yield return new NamedFeature(crossing.Id, LogFeatureKind.Crosswalk, 0, crossing.Corners);
        }

        foreach (
            ObjectLabel sign in label.Objects.Where(item =>
                item is { Class: ObjectClass.Sign, GovernedLanes.Count: > 0, Face.MutcdCode: StopSignCode }
            )
        )
        {
            yield return new NamedFeature(
                FormattableString.Invariant($"sign {sign.Parent ?? sign.Id}"),
                LogFeatureKind.StopSign,
                0,
                [sign.Box3D.Centre]
            )
            {
                Lanes = sign.GovernedLanes!,
            };
        }
    }

    private static NamedFeature LaneOf(LaneNetwork map, MapLane lane) =>
        new(lane.Id, LogFeatureKind.Lane, IsOfHighway(map, lane) ? Freeway : Street, lane.Centre)
        {
            IsWay = lane.Junction is not null,
            Entries = [.. lane.Predecessors.Select(before => before.Id)],
            Exits = [.. lane.Successors.Select(next => next.Id)],
            Left = lane.LeftNeighbour is { } left ? [left.Id] : [],
            Right = lane.RightNeighbour is { } right ? [right.Id] : [],
            LeftLines =
                lane.Junction is not null ? []
                : lane.Oncoming is not null ? [LeftLine(LineOwner(lane))]
                : [LeftLine(lane), LeftEdge(lane)],
            RightLines =
                lane.Junction is not null ? []
                : lane.RightNeighbour is { } beside ? [LeftLine(beside)]
                : [RightLine(lane), RightEdge(lane)],
        };

    private static bool IsOfHighway(LaneNetwork map, MapLane lane)
    {
        int? road = lane.Link ?? lane.Predecessors.Concat(lane.Successors).FirstOrDefault(next => next.Link is not null)?.Link;
        return road is { } link
            && (
                (map.Network.Nodes[map.Network.Links[link].From].Flags & map.Network.Nodes[map.Network.Links[link].To].Flags)
                & RoadNodeFlags.Highway
            ) != 0;
    }

    /// <summary>Of two lanes with opposite directions, the one whose edge is the line between them.</summary>
    private static MapLane LineOwner(MapLane lane) =>
        lane is { IsForward: false, Oncoming: { } other } && other.Oncoming == lane ? other : lane;

    private static string LeftLine(MapLane lane) => lane.Id + "|left";

    private static string RightLine(MapLane lane) => lane.Id + "|right";

    private static string LeftEdge(MapLane lane) => lane.Id + "|left edge";

    private static string RightEdge(MapLane lane) => lane.Id + "|right edge";

    /// <summary>WOMD's number of a line's paint; 0 if none was seen along most of it.</summary>
    private static int TypeOfPaint(MarkingPaint? paint) =>
        paint is not { } known ? 0
        : known.Colour == MarkingColour.White
            ? known.Style switch
            {
                MarkingStyle.Dashed => 1,
                MarkingStyle.Solid => 2,
                _ => 3,
            }
        : known.Style switch
        {
            MarkingStyle.Dashed => 4,
            MarkingStyle.Solid => 6,
            _ => 7,
        };
}
