using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>The vehicle that carries the camera.</summary>
/// <param name="Position">The model's origin, metres, world.</param>
/// <param name="HeadingDegrees">Degrees counter-clockwise from north, in [0, 360).</param>
/// <param name="Velocity">Metres per second, world.</param>
/// <param name="Model">The model's name.</param>
public sealed record EgoLabel(Vector3D Position, double HeadingDegrees, Vector3D Velocity, string Model)
{
    /// <summary>The body's axes in the world; null in sessions of earlier versions.</summary>
    public Axes? Axes { get; init; }

    /// <summary>Vertical distance from the model's origin down to the ground, metres; null if unknown.</summary>
    public double? HeightAboveGroundMetres { get; init; }

    /// <summary>How it moves and what its driver does; null if unknown.</summary>
    public EgoMotion? Motion { get; init; }

    /// <summary>Creates the label of a vehicle that carries the camera.</summary>
    /// <exception cref="System.ArgumentNullException"><paramref name="ego"/> is null.</exception>
    public static EgoLabel Of(EgoState ego)
    {
        Pose pose = (ego ?? throw new System.ArgumentNullException(nameof(ego))).Pose;
        return new EgoLabel(pose.Position, Angles.HeadingDegrees(pose.Axes.Forward), ego.Velocity, ego.Model)
        {
            Axes = pose.Axes,
            HeightAboveGroundMetres = ego.HeightAboveGroundMetres,
            Motion = ego.Motion,
        };
    }
}
