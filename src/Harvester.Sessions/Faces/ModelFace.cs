using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Faces;

/// <summary>The face of a sign or the head of a traffic light on a model. Algorithm 3 of the thesis.</summary>
/// <param name="Model">The model's name in lower case; empty if a file gives only the hash.</param>
/// <param name="Hash">The model's hash.</param>
/// <param name="Class">Sign or traffic light.</param>
/// <param name="Name">What the sign says; empty if unknown.</param>
/// <param name="MutcdCode">Code of the sign in the Manual on Uniform Traffic Control Devices; empty if it has none or it is
/// unknown.</param>
/// <param name="Number">Number of the face on its model, from 0.</param>
/// <param name="FrontUpperLeft">Front, upper, left corner in the model's frame: minimum x, maximum y, maximum z; metres.</param>
/// <param name="BackLowerRight">Back, lower, right corner in the model's frame: maximum x, minimum y, minimum z; metres.</param>
/// <param name="Facing">The direction in which the face looks.</param>
/// <param name="Provenance">How the corners were obtained.</param>
/// <param name="Source">Where they come from, as text.</param>
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
    string Source
)
{
    /// <summary>The face's cuboid in the world, for an entity of its model at a pose.</summary>
    public Cuboid CuboidAt(Pose entity) =>
        Cuboid.FromModel(
            new Vector3D(FrontUpperLeft.X, BackLowerRight.Y, BackLowerRight.Z),
            new Vector3D(BackLowerRight.X, FrontUpperLeft.Y, FrontUpperLeft.Z),
            entity
        );

    /// <summary>The direction in the world in which the face looks, for an entity of its model at a pose.</summary>
    public Vector3D DirectionAt(Pose entity) =>
        Facing switch
        {
            Facing.Front => entity.Axes.Forward,
            Facing.Left => -entity.Axes.Right,
            Facing.Right => entity.Axes.Right,
            _ => -entity.Axes.Forward,
        };
}
