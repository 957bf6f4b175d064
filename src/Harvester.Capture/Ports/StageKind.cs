namespace Harvester.Capture.Ports;

/// <summary>What an actor is.</summary>
public enum StageKind
{
    /// <summary>A car, truck, bus or motorcycle.</summary>
    Vehicle,

    /// <summary>A bicycle with its rider.</summary>
    Cyclist,

    /// <summary>A person on foot.</summary>
    Pedestrian,

    /// <summary>An animal.</summary>
    Animal,

    /// <summary>A thing that does not move by itself.</summary>
    Object,
}
