using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>An entity, or a face of one, that is in the image, before its occlusion is known.</summary>
/// <param name="Entity">The entity.</param>
/// <param name="Id">The object's id in the session.</param>
/// <param name="Cuboid">Its cuboid, world frame, metres.</param>
/// <param name="Projection">The cuboid's projection, with both boxes.</param>
internal sealed record LabelCandidate(EntityState Entity, ushort Id, Cuboid Cuboid, CuboidProjection Projection)
{
    /// <summary>The id of the two-wheeler that a rider sits on; null for other classes and if that is not in the scene.</summary>
    public ushort? VehicleId { get; init; }

    /// <summary>The box around its part inside the image, pixels.</summary>
    public Box2D Box => Projection.Box!.Value;

    /// <summary>The distance of its centre from a camera, metres.</summary>
    public double DistanceFrom(Camera camera) => (Cuboid.Centre - camera.Pose.Position).Length;

    /// <summary>The label of an entity, and the part of a face's label that is the same.</summary>
    /// <param name="camera">The camera of the image.</param>
    /// <param name="objectClass">The class of the label.</param>
    /// <param name="occlusion">Its occlusion.</param>
    /// <param name="knownParts">Number of faces known on its model; null for a face and without a table of faces.</param>
    public ObjectLabel Label(Camera camera, ObjectClass objectClass, OcclusionEstimate occlusion, int? knownParts = null) =>
        new()
        {
            Id = Id,
            Class = objectClass,
            Model = Entity.Model,
            KnownParts = knownParts,
            HasRider = Entity.HasRider,
            Vehicle = VehicleId,
            Lights = Entity.Lights,
            Box2D = Box,
            Box2DAmodal = Projection.AmodalBox!.Value,
            TruncatedFraction = Projection.TruncatedFraction,
            OccludedFraction = occlusion.Method == OcclusionMethod.None ? null : occlusion.OccludedFraction,
            OcclusionMethod = occlusion.Method,
            Box3D = Cuboid,
            DistanceMetres = DistanceFrom(camera),
            Velocity = Entity.Velocity,
        };
}
