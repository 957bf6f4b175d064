using Harvester.Geometry;

namespace Harvester.Sessions.Scenes;

/// <summary>The vehicle that carries the camera.</summary>
/// <param name="Handle">The game's handle; 0 if the camera is not on a vehicle.</param>
/// <param name="Model">The model's name in lower case.</param>
/// <param name="Pose">Position of the model's origin (metres, world) and orientation.</param>
/// <param name="Velocity">Metres per second, world.</param>
public sealed record EgoState(int Handle, string Model, Pose Pose, Vector3D Velocity)
{
    /// <summary>Rear, left, lower corner of the model's box in its own frame, metres; zero if unknown.</summary>
    public Vector3D ModelMin { get; init; }

    /// <summary>Front, right, upper corner of the model's box in its own frame, metres; zero if unknown.</summary>
    public Vector3D ModelMax { get; init; }

    /// <summary>Vertical distance from the model's origin down to the ground, metres; null if unknown.</summary>
    public double? HeightAboveGroundMetres { get; init; }

    /// <summary>How it moves and what its driver does; null if unknown.</summary>
    public EgoMotion? Motion { get; init; }
}
