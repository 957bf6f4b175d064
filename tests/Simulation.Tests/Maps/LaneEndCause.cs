namespace Harvester.Simulation.Tests.Maps;

/// <summary>Why a lane has no successor, or no predecessor.</summary>
internal enum LaneEndCause
{
    /// <summary>No cause is known: it may be a fault of the map.</summary>
    None,

    /// <summary>The road data has no other road at the node.</summary>
    RoadEnds,

    /// <summary>All other roads at the node, or in the junction, are one-way roads in the wrong direction.</summary>
    OneWayRoads,

    /// <summary>All other roads turn back by more than 115 degrees, or 137 degrees in a junction.</summary>
    SharpTurn,

    /// <summary>All other roads of the junction lie behind the lane, or it behind them.</summary>
    RoadsBehind,

    /// <summary>The links within the junction do not lead to the roads that lie ahead.</summary>
    NotLinked,
}
