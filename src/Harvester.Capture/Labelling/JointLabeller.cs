using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Labels the joints of the listed people, with one ray per joint in the image.</summary>
internal sealed class JointLabeller(LabellingOptions options, FrameRays rays)
{
    /// <summary>Labels the people of a frame in steps of a few rays.</summary>
    /// <param name="draft">The frame with its objects, which receive their joints, and their ids.</param>
    /// <param name="mayCastRays">Called before each person; if it returns false, visibility is unknown.</param>
    public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        var found = new Dictionary<int, JointsLabel>();
        var listed = new HashSet<int>(draft.Objects.Select(label => label.Id));
        foreach (EntityState entity in draft.Snapshot.Entities)
        {
            if (entity.Skeleton is { } skeleton && draft.Ids.TryGetValue(entity.Handle, out int id) && listed.Contains(id))
            {
                var seen = new JointVisibility[Skeleton.Count];
                Joint[] asked = mayCastRays() && rays.Left >= Skeleton.Count ? [.. InImage(draft.Camera, skeleton)] : [];
                for (int i = 0; i < asked.Length; i++)
                {
                    seen[(int)asked[i]] = VisibilityOf(draft.Camera, entity, asked[i], draft.Snapshot.Ego.Handle);
                    if ((i + 1) % OcclusionEstimator.RaysOfAStep == 0)
                    {
                        yield return WorkStep.Pause;
                    }
                }

                found[id] = JointLabels.Of(draft.Camera, skeleton, joint => seen[(int)joint]);
                yield return WorkStep.Pause;
            }
        }

        draft.Update(label => found.TryGetValue(label.Id, out JointsLabel? joints) ? label with { Joints = joints } : label);
    }

    private static IEnumerable<Joint> InImage(Camera camera, Skeleton skeleton) =>
        Enumerable
            .Range(0, Skeleton.Count)
            .Select(number => (Joint)number)
            .Where(joint => camera.Project(skeleton[joint]).Outcome == ProjectionOutcome.InImage);

    /// <summary>
    /// Whether a joint is visible. Joints lie inside the body: a ray that meets the person within the depth of the joint below its own
    /// surface has met that surface.
    /// </summary>
    private JointVisibility VisibilityOf(Camera camera, EntityState entity, Joint joint, int egoHandle)
    {
        Vector3D toJoint = entity.Skeleton![joint] - camera.Pose.Position;
        double distance = toJoint.Length;
        if (distance > options.RayReachMetres)
        {
            return JointVisibility.Unknown;
        }

        RayHit? hit = rays.Cast(new Ray(camera.Pose.Position, toJoint), distance, egoHandle);
        return hit is not { } first ? JointVisibility.Visible
            : first.Entity != entity.Handle ? JointVisibility.Occluded
            : distance - first.Distance <= JointSizes.Depths[(int)joint] ? JointVisibility.Visible
            : JointVisibility.SelfOccluded;
    }
}
