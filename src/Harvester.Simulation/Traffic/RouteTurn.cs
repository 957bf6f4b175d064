namespace Harvester.Simulation.Traffic;

/// <summary>How a route leaves a junction; straight up to 0.6 rad.</summary>
public enum RouteTurn
{
    /// <summary>To the left.</summary>
    Left,

    /// <summary>Straight on.</summary>
    Straight,

    /// <summary>To the right.</summary>
    Right,
}
