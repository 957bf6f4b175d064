using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>Reads from the game what the overlay needs, value by value.</summary>
/// <param name="mount">The camera and the vehicle that carries it.</param>
/// <param name="world">Lists nearby entities and knows the models.</param>
internal sealed class GameSight(CameraMount mount, GameWorld world) : ISightReader
{
    /// <inheritdoc/>
    public int MountedVehicle => mount.Vehicle;

    /// <inheritdoc/>
    public Pose CameraPose => RenderedCamera.Pose;

    /// <inheritdoc/>
    public double VerticalFovDegrees => RenderedCamera.VerticalFovDegrees;

    /// <inheritdoc/>
    public double NearClip => RenderedCamera.NearClip;

    /// <inheritdoc/>
    public double WindowAspect => RenderedCamera.WindowAspect;

    /// <inheritdoc/>
    public IReadOnlyList<int> Near(EntityKind kind, Vector3D centre, double range) => world.Near(kind, centre, range);

    /// <inheritdoc/>
    public ModelFacts FactsOf(EntityKind kind, int entity) => world.FactsOf(kind, entity);

    /// <inheritdoc/>
    public bool IsPerson(int ped) => Natives.IsPerson(ped);

    /// <inheritdoc/>
    public bool IsInVehicle(int ped) => Natives.IsInVehicle(ped);

    /// <inheritdoc/>
    public ScaledPose? PlaceOf(int entity) => Natives.EntityMatrix(entity);
}
