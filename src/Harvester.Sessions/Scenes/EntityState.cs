using Harvester.Geometry;

namespace Harvester.Sessions.Scenes;

/// <summary>A vehicle, pedestrian or prop at one moment: plain data that never asks the game again.</summary>
/// <param name="Handle">The game's handle, not 0. Handles are given again to later entities.</param>
/// <param name="Class">What kind of thing it is.</param>
/// <param name="Model">The model's name in small letters, or its hash as 0xXXXXXXXX where the name is unknown.</param>
/// <param name="Pose">Position of the model's origin (metres, world) and orientation.</param>
/// <param name="ModelMin">Rear, left, lower corner of the model's box in its own frame, metres.</param>
/// <param name="ModelMax">Front, right, upper corner of the model's box in its own frame, metres.</param>
/// <param name="Velocity">Metres per second, world.</param>
public sealed record EntityState(
    int Handle, ObjectClass Class, string Model, Pose Pose, Vector3D ModelMin, Vector3D ModelMax, Vector3D Velocity)
{
    /// <summary>Whether somebody sits on a motorcycle or bicycle; null for everything else and when unknown.</summary>
    public bool? HasRider { get; init; }
}
