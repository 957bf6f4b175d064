namespace Harvester.Simulation.Models;

/// <summary>What a lamp of a vehicle says.</summary>
internal enum LampKind
{
    /// <summary>A headlight.</summary>
    Head,

    /// <summary>A tail lamp, which is dim with the headlights and bright with the brakes.</summary>
    Tail,

    /// <summary>The third brake light, which is dark unless the vehicle brakes.</summary>
    HighBrake,

    /// <summary>An indicator on the left.</summary>
    Left,

    /// <summary>An indicator on the right.</summary>
    Right,
}
