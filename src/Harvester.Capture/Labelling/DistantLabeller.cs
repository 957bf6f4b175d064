using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Marks visible objects beyond the labelling range as ignore regions, so that they do not count as background.</summary>
internal sealed class DistantLabeller(LabellingOptions options)
{
    /// <summary>The distant entities of a scene that are in the image and large enough to be labelled if they were nearer.</summary>
    public IEnumerable<DistantCandidate> CandidatesOf(Camera camera, IEnumerable<EntityState> distant) =>
        from entity in distant
        where options.Classes?.Contains(entity.Class) ?? true
        select CandidateOf(camera, entity) into candidate
        where candidate is not null
        select candidate;

    /// <summary>Finds out with few rays whether a candidate is visible, in steps.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="candidate">The candidate.</param>
    /// <param name="egoHandle">Handle of the vehicle with the camera.</param>
    /// <param name="rays">The ray caster.</param>
    /// <param name="sight">Receives the finding.</param>
    public IEnumerable<WorkStep> LookInSteps(
        Camera camera,
        DistantCandidate candidate,
        int egoHandle,
        IRayCaster rays,
        WorkResult<Sight> sight
    )
    {
        if (options.IsWithinReach(camera, candidate.Cuboid))
        {
            return SightFinder.FindInSteps(camera, candidate.Cuboid, candidate.Projection, candidate.Entity.Handle, egoHandle, rays, sight);
        }

        sight.Value = Sight.Undetermined;
        return [];
    }

    /// <summary>The ignore region of a candidate; null if it is not visible.</summary>
    public static IgnoreRegion? RegionOf(Camera camera, DistantCandidate candidate, Sight sight) =>
        sight == Sight.Unseen
            ? null
            : new IgnoreRegion(
                sight == Sight.Seen ? IgnoreReason.BeyondRange : IgnoreReason.Undetermined,
                candidate.Entity.Class,
                candidate.Box,
                (candidate.Cuboid.Centre - camera.Pose.Position).Length
            );

    private DistantCandidate? CandidateOf(Camera camera, EntityState entity)
    {
        Cuboid cuboid = Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose);
        return CuboidProjector.BoxesOf(camera, cuboid).Box is { } box && options.IsLargeEnough(box)
            ? new DistantCandidate(entity, cuboid, CuboidProjector.Project(camera, cuboid), box)
            : null;
    }
}
