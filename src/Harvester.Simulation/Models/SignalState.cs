namespace Harvester.Simulation.Models;

/// <summary>The lit lamp of a traffic light.</summary>
public enum SignalState
{
    /// <summary>Stop.</summary>
    Red,

    /// <summary>Clear the junction.</summary>
    Amber,

    /// <summary>Go.</summary>
    Green,
}
