namespace Harvester.Simulation.Models;

/// <summary>Which lamp of a traffic light burns.</summary>
public enum SignalState
{
    /// <summary>Stop.</summary>
    Red,

    /// <summary>Clear the junction.</summary>
    Amber,

    /// <summary>Go.</summary>
    Green,
}
