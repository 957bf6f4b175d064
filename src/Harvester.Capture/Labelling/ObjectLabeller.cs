using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>What of an object's label is geometry: whether it is in the image, its boxes, and whether it is listed once its occlusion is known.</summary>
internal sealed class ObjectLabeller(LabellingOptions options, ObjectRegistry registry)
{
    /// <summary>The entities in the image, numbered.</summary>
    public List<LabelCandidate> CandidatesOf(Camera camera, SceneSnapshot snapshot) =>
        [.. snapshot.Entities.Select(entity => CandidateOf(camera, entity)).OfType<LabelCandidate>()];

    private LabelCandidate? CandidateOf(Camera camera, EntityState entity)
    {
        if (options.Classes is { } classes && !classes.Contains(entity.Class))
        {
            return null;
        }

        Cuboid cuboid = Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose);
        CuboidProjection projection = CuboidProjector.Project(camera, cuboid);
        return projection is { Box: { } box, AmodalBox: { } amodal }
            && options.IsLargeEnough(box)
            ? new LabelCandidate(entity, registry.IdOf(entity), cuboid, projection, box, amodal)
            : null;
    }

    /// <summary>The label of an entity in the image; null when it is not listed.</summary>
    public ObjectLabel? LabelOf(Camera camera, LabelCandidate candidate, OcclusionEstimate occlusion)
    {
        if (!options.IsListed(occlusion))
        {
            return null;
        }

        EntityState entity = candidate.Entity;
        return new ObjectLabel
        {
            Id = candidate.Id,
            Class = entity.Class,
            Model = entity.Model,
            KnownParts = options.Faces?.Of(entity.Model).Count,
            HasRider = entity.HasRider,
            Box2D = candidate.Box,
            Box2DAmodal = candidate.AmodalBox,
            TruncatedFraction = candidate.Projection.TruncatedFraction,
            OccludedFraction = occlusion.Method == OcclusionMethod.None ? null : occlusion.OccludedFraction,
            OcclusionMethod = occlusion.Method,
            Box3D = candidate.Cuboid,
            DistanceMetres = (candidate.Cuboid.Centre - camera.Pose.Position).Length,
            Velocity = entity.Velocity,
        };
    }

    /// <summary>The ignore region of an entity in the image; null unless it could not be determined whether it is seen.</summary>
    public static IgnoreRegion? RegionOf(Camera camera, LabelCandidate candidate, OcclusionEstimate occlusion) => occlusion.Sight == Sight.Undetermined
        ? new IgnoreRegion(
            IgnoreReason.Undetermined, candidate.Entity.Class, candidate.Box, (candidate.Cuboid.Centre - camera.Pose.Position).Length)
        : null;
}
