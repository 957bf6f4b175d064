using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the labels of faces of signs and heads of traffic lights. Algorithm 3 of the thesis.</summary>
internal sealed class FaceLabeller(FaceTable table, LabellingOptions options, FrameRays? rays, ILights? lights, ObjectRegistry registry)
{
    /// <summary>Margin for the rounding of a measured face's corners, metres; less than the thickness of a sign's plate.</summary>
    private const double MeasuredMarginMetres = 0.005;

    /// <summary>
    /// Maximum distance of an estimated cuboid in front of or behind the plate, metres; with less, faces would count as hidden by their own
    /// plates.
    /// </summary>
    private const double EstimatedMarginMetres = 0.15;

    /// <summary>
    /// Width of the backplate around the head of a light, metres: 5 inches is the usual size, and a corner may be rounded.
    /// </summary>
    private const double BackplateMetres = 0.15;

    private readonly OcclusionEstimator _occlusion = new(options.OcclusionSamples);

    /// <summary>Labels the faces of entities in steps.</summary>
    /// <param name="draft">The frame with its entities; receives each face in the image.</param>
    /// <param name="mayCastRays">Called before each face; if it returns false, the face has no occlusion.</param>
    public IEnumerable<WorkStep> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        (Camera camera, SceneSnapshot snapshot) = (draft.Camera, draft.Snapshot);
        var estimate = new WorkResult<OcclusionEstimate>();
        foreach (FaceCandidate? candidate in CandidatesOf(camera, snapshot))
        {
            yield return WorkStep.Pause;
            if (candidate is null)
            {
                continue;
            }

            OcclusionEstimate parent = draft.OcclusionOf(candidate.Seen.Entity.Handle);
            OcclusionEstimate occlusion = default;
            if (parent.Sight is Sight.Unseen or Sight.Undetermined)
            {
                occlusion = parent;
            }
            else if (mayCastRays() && rays?.Left >= _occlusion.MaxRays)
            {
                yield return WorkStep.Do(EstimateInSteps(camera, candidate, snapshot.Ego.Handle, rays, estimate));
                occlusion = estimate.Value;
            }

            Add(draft, candidate, occlusion);
        }
    }

    /// <summary>Adds a face to a frame. It gets an ignore region only if its object has none.</summary>
    public void Add(FrameDraft draft, FaceCandidate candidate, OcclusionEstimate occlusion)
    {
        (Camera camera, SceneSnapshot snapshot) = (draft.Camera, draft.Snapshot);
        LabelCandidate seen = candidate.Seen;
        int handle = seen.Entity.Handle;
        bool isParentMarked = draft.OcclusionOf(handle).Sight == Sight.Undetermined;
        draft.Add(
            RecordedOcclusion.Of(handle, candidate.Face.Number, seen.Id, occlusion, lights?.SetStateOf(handle, snapshot.GameFrame)),
            occlusion,
            LabelOf(camera, snapshot, candidate, occlusion),
            isParentMarked ? null : ObjectLabeller.RegionOf(camera, seen, occlusion)
        );
    }

    /// <summary>Passes over a snapshot that is not labelled; the ids of its faces are assigned all the same.</summary>
    public void Pass(Camera camera, SceneSnapshot snapshot)
    {
        foreach (FaceCandidate? _ in CandidatesOf(camera, snapshot))
        {
            // Finding a candidate assigns its id.
        }
    }

    /// <summary>
    /// The faces of entities with their ids; null for one that is not in the image, and for a sign's face seen from behind. The head of a
    /// light is a housing, visible from all sides.
    /// </summary>
    public IEnumerable<FaceCandidate?> CandidatesOf(Camera camera, SceneSnapshot snapshot) =>
        from entity in snapshot.Entities
        from face in table.Of(entity.Model)
        where options.Classes is null || options.Classes.Contains(face.Class)
        select CandidateOf(camera, entity, face);

    private FaceCandidate? CandidateOf(Camera camera, EntityState entity, ModelFace face)
    {
        Cuboid cuboid = face.CuboidAt(entity.Pose);
        if (face.Class == ObjectClass.Sign && !FaceLabel.IsBefore(FacingAngleDegrees(face, cuboid, entity.Pose, camera.Pose.Position)))
        {
            return null;
        }

        CuboidProjection projection = CuboidProjector.Project(camera, cuboid, FaceOutline.EdgesOf(face, entity.Pose));
        return projection is { Box: { } box, AmodalBox: not null } && options.IsLargeEnough(box)
            ? new FaceCandidate(
                face,
                new LabelCandidate(entity, registry.IdOf(entity, face.Number), cuboid, projection),
                registry.IdOf(entity)
            )
            : null;
    }

    /// <summary>The label of a face in the image; null if it is not listed.</summary>
    private ObjectLabel? LabelOf(Camera camera, SceneSnapshot snapshot, FaceCandidate candidate, OcclusionEstimate occlusion)
    {
        if (!options.IsListed(occlusion))
        {
            return null;
        }

        (ModelFace face, LabelCandidate seen, int parent) = candidate;
        EntityState entity = seen.Entity;
        return seen.Label(camera, face.Class, occlusion) with
        {
            Name = face.Name.Length == 0 ? null : face.Name,
            Parent = parent,
            Face = new FaceLabel(
                face.Number,
                face.MutcdCode.Length == 0 ? null : face.MutcdCode,
                FacingAngleDegrees(face, seen.Cuboid, entity.Pose, camera.Pose.Position),
                face.Provenance,
                face.Class == ObjectClass.TrafficLight ? LightOf(entity, snapshot.GameFrame) : null
            ),
        };
    }

    private IEnumerable<WorkStep> EstimateInSteps(
        Camera camera,
        FaceCandidate candidate,
        int egoHandle,
        IRayCaster caster,
        WorkResult<OcclusionEstimate> estimate
    )
    {
        LabelCandidate seen = candidate.Seen;
        int parent = seen.Entity.Handle;
        FaceRays rays = new(caster, parent, seen.Cuboid, MarginOf(candidate.Face));
        return _occlusion.EstimateInSteps(camera, seen.Cuboid, seen.Projection, parent, egoHandle, rays, estimate);
    }

    private static Vector3D MarginOf(ModelFace face)
    {
        double depth = face.Provenance == Provenance.Estimated ? EstimatedMarginMetres : MeasuredMarginMetres;
        double side = face.Class == ObjectClass.TrafficLight ? Math.Max(depth, BackplateMetres) : depth;
        return face.Facing is Facing.Left or Facing.Right ? new Vector3D(depth, side, side) : new Vector3D(side, depth, side);
    }

    private LightLabel LightOf(EntityState entity, long gameFrame) =>
        lights?.SetStateOf(entity.Handle, gameFrame) is { } state ? new LightLabel(state, LightMethod.Set, null) : LightLabel.Unknown;

    /// <summary>
    /// The angle between two directions from the tangent of its half, which is accurate near 0 and 180 degrees as well; 0 for a camera in
    /// the middle of the face.
    /// </summary>
    private static double FacingAngleDegrees(ModelFace face, Cuboid cuboid, Pose entity, Vector3D eye)
    {
        Vector3D outward = face.DirectionAt(entity);
        Vector3D half = cuboid.HalfExtents;
        double depth = face.Facing is Facing.Left or Facing.Right ? half.X : half.Y;
        Vector3D toEye = eye - (cuboid.Centre + (outward * depth));
        if (toEye.Length == 0)
        {
            return 0;
        }

        Vector3D direction = toEye.Normalized();
        return Angles.ToDegrees(2 * Math.Atan2((direction - outward).Length, (direction + outward).Length));
    }
}
