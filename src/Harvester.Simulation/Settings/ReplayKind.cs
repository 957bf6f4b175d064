namespace Harvester.Simulation.Settings;

/// <summary>What is replayed.</summary>
public enum ReplayKind
{
    /// <summary>A car, truck, bus or motorcycle.</summary>
    Vehicle,

    /// <summary>A bicycle with its rider.</summary>
    Cyclist,

    /// <summary>A person on foot.</summary>
    Pedestrian,
}
