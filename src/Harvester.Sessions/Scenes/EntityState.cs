using Harvester.Geometry;

namespace Harvester.Sessions.Scenes;

/// <summary>A vehicle, pedestrian or prop at one moment, as plain data independent of the game.</summary>
/// <param name="Handle">The game's handle, not 0. The game reuses handles for later entities.</param>
/// <param name="Class">Its class.</param>
/// <param name="Model">The model's name in lower case, or its hash as 0xXXXXXXXX if the name is unknown.</param>
/// <param name="Pose">Position of the model's origin (metres, world) and orientation.</param>
/// <param name="ModelMin">Rear, left, lower corner of the model's box in its own frame, metres.</param>
/// <param name="ModelMax">Front, right, upper corner of the model's box in its own frame, metres.</param>
/// <param name="Velocity">Metres per second, world.</param>
public sealed record EntityState(
    int Handle,
    ObjectClass Class,
    string Model,
    Pose Pose,
    Vector3D ModelMin,
    Vector3D ModelMax,
    Vector3D Velocity
)
{
    /// <summary>Whether somebody sits on a motorcycle or bicycle; null for other classes and if unknown.</summary>
    public bool? HasRider { get; init; }

    /// <summary>Handle of the motorcycle or bicycle that a rider sits on; null for other classes.</summary>
    public int? VehicleHandle { get; init; }

    /// <summary>The lamps of a vehicle that shine; null for other classes and if unknown.</summary>
    public VehicleLights? Lights { get; init; }

    /// <summary>The joints of a person, metres, world; null for other classes and if unknown.</summary>
    public Skeleton? Skeleton { get; init; }
}
