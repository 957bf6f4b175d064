using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads.JsonDump;

/// <summary>A node of the JSON dump. Nodes listed as neighbours have no connections.</summary>
internal sealed class DumpNode
{
    public required int Id { get; init; }

    public required DumpPosition Position { get; init; }

    public string? StreetName { get; init; }

    public bool IsValidForGps { get; init; }

    public bool IsJunction { get; init; }

    public bool IsFreeway { get; init; }

    public bool IsGravelRoad { get; init; }

    public bool IsBackroad { get; init; }

    public bool IsOnWater { get; init; }

    public bool IsPedCrossway { get; init; }

    public bool TrafficlightExists { get; init; }

    public bool LeftTurnNoReturn { get; init; }

    public bool RightTurnNoReturn { get; init; }

    public IReadOnlyList<DumpConnection>? ConnectedNodes { get; init; }

    /// <summary>
    /// The flags, by the names that the game uses. The dump calls nodes without traffic back roads, as it does all nodes on water. It sets
    /// both a light and a crossing for a stop line at a light, because the number of that kind has the bits of both.
    /// </summary>
    public RoadNodeFlags Flags() =>
        When(!IsValidForGps, RoadNodeFlags.NoGps)
        | When(IsJunction, RoadNodeFlags.Junction)
        | When(IsFreeway, RoadNodeFlags.Highway)
        | When(IsGravelRoad, RoadNodeFlags.OffRoad)
        | When(IsBackroad, RoadNodeFlags.SwitchedOff)
        | When(IsOnWater, RoadNodeFlags.Water)
        | When(IsPedCrossway && !TrafficlightExists, RoadNodeFlags.PedestrianCrossing)
        | When(TrafficlightExists, RoadNodeFlags.TrafficLight)
        | When(LeftTurnNoReturn, RoadNodeFlags.IndicateKeepLeft)
        | When(RightTurnNoReturn, RoadNodeFlags.IndicateKeepRight);

    private static RoadNodeFlags When(bool isSet, RoadNodeFlags flag) => isSet ? flag : RoadNodeFlags.None;
}
