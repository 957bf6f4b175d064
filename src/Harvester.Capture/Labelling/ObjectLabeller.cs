using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The geometry of object labels: which entities are in the image, their boxes, and whether an object is listed once its occlusion is
/// known.
/// </summary>
internal sealed class ObjectLabeller(LabellingOptions options, ObjectRegistry registry)
{
    /// <summary>The entities in the image, with their ids.</summary>
    public List<LabelCandidate> CandidatesOf(Camera camera, SceneSnapshot snapshot) =>
        [.. snapshot.Entities.Select(entity => CandidateOf(camera, snapshot, entity)).OfType<LabelCandidate>()];

    private LabelCandidate? CandidateOf(Camera camera, SceneSnapshot snapshot, EntityState entity)
    {
        if (options.Classes is { } classes && !classes.Contains(entity.Class))
        {
            return null;
        }

        Cuboid cuboid = Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose);
        return CuboidProjector.BoxesOf(camera, cuboid).Box is { } box && options.IsLargeEnough(box)
            ? new LabelCandidate(entity, registry.IdOf(entity), cuboid, CuboidProjector.Project(camera, cuboid))
            {
                VehicleId = entity.VehicleHandle is { } handle ? IdOf(snapshot, handle) : null,
            }
            : null;
    }

    private ushort? IdOf(SceneSnapshot snapshot, int handle) =>
        snapshot.Entities.FirstOrDefault(other => other.Handle == handle) is { } entity ? registry.IdOf(entity) : null;

    /// <summary>Whether the box of a nearer entity overlaps that of an entity in the image.</summary>
    public static bool IsOverlapped(Camera camera, LabelCandidate candidate, List<LabelCandidate> all)
    {
        double distance = candidate.DistanceFrom(camera);
        return all.Exists(other => other.DistanceFrom(camera) < distance && other.Box.Intersect(candidate.Box) is not null);
    }

    /// <summary>The label of an entity in the image; null if it is not listed.</summary>
    public ObjectLabel? LabelOf(Camera camera, LabelCandidate candidate, OcclusionEstimate occlusion) =>
        options.IsListed(occlusion)
            ? candidate.Label(camera, candidate.Entity.Class, occlusion, options.Faces?.Of(candidate.Entity.Model).Count)
            : null;

    /// <summary>The ignore region of an entity in the image; null unless its visibility could not be determined.</summary>
    public static IgnoreRegion? RegionOf(Camera camera, LabelCandidate candidate, OcclusionEstimate occlusion) =>
        occlusion.Sight == Sight.Undetermined
            ? new IgnoreRegion(IgnoreReason.Undetermined, candidate.Entity.Class, candidate.Box, candidate.DistanceFrom(camera))
            : null;
}
