using System.Collections.Generic;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads.JsonDump;

/// <summary>A node of the JSON dump; as a neighbour it has no connections of its own.</summary>
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
    /// The flags by the game's names. The dump calls nodes without traffic back roads (every node on water is one), and it gives
    /// both a light and a crossing where the node's kind is the stop line of a light, whose number has the bits of both.
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
