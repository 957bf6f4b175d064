namespace Harvester.Simulation.Settings;

/// <summary>What a <see cref="WorldChange"/> does.</summary>
public enum WorldChangeKind
{
    /// <summary>A driver brakes to a stop and stands.</summary>
    Brake,

    /// <summary>A driver aims for another speed.</summary>
    Drive,

    /// <summary>A vehicle or person disappears.</summary>
    Remove,

    /// <summary>The weather changes.</summary>
    Weather,
}
