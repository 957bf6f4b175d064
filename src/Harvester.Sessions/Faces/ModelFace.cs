using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Faces;

/// <summary>The part of a model that matters: the face of a sign, a head of a traffic light. Algorithm 3 of the thesis.</summary>
/// <param name="Model">The model's name in small letters; empty where a file gives only the hash.</param>
/// <param name="Hash">The model's hash.</param>
/// <param name="Class">Sign or traffic light.</param>
/// <param name="Name">What the sign says; empty when unknown.</param>
/// <param name="MutcdCode">Code of the sign in the Manual on Uniform Traffic Control Devices; empty when it has none or it is
/// unknown.</param>
/// <param name="Number">Number of the face on its model, from 0.</param>
/// <param name="FrontUpperLeft">Front, upper, left corner in the model's frame: least x, greatest y, greatest z; metres.</param>
/// <param name="BackLowerRight">Back, lower, right corner in the model's frame: greatest x, least y, least z; metres.</param>
/// <param name="Facing">The side towards which the face looks.</param>
/// <param name="Provenance">How the corners were come by.</param>
/// <param name="Source">Where they are from, in words.</param>
public sealed record ModelFace(
    string Model,
    int Hash,
    ObjectClass Class,
    string Name,
    string MutcdCode,
    int Number,
    Vector3D FrontUpperLeft,
    Vector3D BackLowerRight,
    Facing Facing,
    Provenance Provenance,
    string Source)
{
    /// <summary>The space's cuboid in the world, for an entity of its model at a pose.</summary>
    public Cuboid CuboidAt(Pose entity) =>
        Cuboid.FromModel(
            new Vector3D(FrontUpperLeft.X, BackLowerRight.Y, BackLowerRight.Z),
            new Vector3D(BackLowerRight.X, FrontUpperLeft.Y, FrontUpperLeft.Z),
            entity);

    /// <summary>The direction in the world towards which the face looks, for an entity of its model at a pose.</summary>
    public Vector3D DirectionAt(Pose entity) => Facing switch
    {
        Facing.Front => entity.Axes.Forward,
        Facing.Left => -entity.Axes.Right,
        Facing.Right => entity.Axes.Right,
        _ => -entity.Axes.Forward,
    };
}
