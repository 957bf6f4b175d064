namespace Harvester.Simulation.Traffic;

/// <summary>What a pedestrian does all the time.</summary>
internal enum Activity
{
    /// <summary>Walks up and down a pavement.</summary>
    Walking,

    /// <summary>Stands on a pavement.</summary>
    Standing,

    /// <summary>Sits on a bench.</summary>
    Sitting,
}
