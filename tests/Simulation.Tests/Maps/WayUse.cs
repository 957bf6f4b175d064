namespace Harvester.Simulation.Tests.Maps;

/// <summary>What the simulation's traffic does with a way of the map.</summary>
internal enum WayUse
{
    /// <summary>It drives from lane to lane and stays between the edges of the way and its lanes.</summary>
    Kept,

    /// <summary>It drives from lane to lane and leaves them in between.</summary>
    Left,

    /// <summary>It drives from the lane to the road, into another of its lanes.</summary>
    OtherLane,

    /// <summary>It drives from the lane, and not to the road.</summary>
    NoRouteLeadsThere,

    /// <summary>None of its routes begins on the lane: it has no road there, or one that lies in a junction.</summary>
    NoRouteBegins,
}
