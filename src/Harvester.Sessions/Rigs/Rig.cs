using Harvester.Geometry;

namespace Harvester.Sessions.Rigs;

/// <summary>The sensors of a vehicle that see each moment of a session together. File format: docs/rigs.md.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Origin">
/// The point of the vehicle from which the sensors are measured, in the frame of the vehicle's model (x right, y forward, z up), metres.
/// Exports take it for the vehicle's own position.
/// </param>
/// <param name="Cameras">The cameras, at least one; each gives a view of every moment, in this order.</param>
/// <param name="Lidars">The LiDARs.</param>
public sealed record Rig(string Name, Vector3D Origin, IReadOnlyList<RigCamera> Cameras, IReadOnlyList<RigLidar> Lidars)
{
    /// <summary>The radars.</summary>
    public IReadOnlyList<RigRadar> Radars { get; init; } = [];

    /// <summary>The pose of a sensor in the frame of the vehicle's model.</summary>
    /// <param name="mount">Its pose relative to <see cref="Origin"/>.</param>
    public Pose OnVehicle(Pose mount) => mount with { Position = Origin + mount.Position };
}
