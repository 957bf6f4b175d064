using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the labels of the parts of objects that matter: faces of signs, heads of traffic lights. Algorithm 3 of the thesis.</summary>
internal sealed class FaceLabeller(FaceTable table, LabellingOptions options, FrameRays? rays, ILights? lights, ObjectRegistry registry)
{
    /// <summary>A face's own surface lies in its cuboid up to the rounding of its corners; less than the thickness of a sign's plate.</summary>
    private const double MeasuredMarginMetres = 0.005;

    /// <summary>An estimated cuboid may lie before or behind the plate by so much; with less, all of its faces would count as hidden by their own plates.</summary>
    private const double EstimatedMarginMetres = 0.15;

    /// <summary>The plate behind the head of a light reaches beyond it by so much: 5 inches is the usual size, and a corner may be rounded.</summary>
    private const double BackplateMetres = 0.15;

    private readonly OcclusionEstimator _occlusion = new(options.OcclusionSamples);

    /// <summary>Labels the faces of entities, a slice each.</summary>
    /// <param name="camera">The camera of the saved image.</param>
    /// <param name="snapshot">The scene.</param>
    /// <param name="findings">Has what was found of the entities, and gets what is found of each face in the image.</param>
    /// <param name="mayCastRays">Asked for each; one that gets a no has no occlusion.</param>
    public IEnumerable<bool> Label(Camera camera, SceneSnapshot snapshot, FrameFindings findings, Func<bool> mayCastRays)
    {
        foreach (FaceCandidate? candidate in CandidatesOf(camera, snapshot))
        {
            yield return true;
            if (candidate is null)
            {
                continue;
            }

            OcclusionEstimate parent = findings.OcclusionOf(candidate.Seen.Entity.Handle);
            OcclusionEstimate occlusion =
                parent.Sight is Sight.Unseen or Sight.Undetermined ? parent
                : mayCastRays() && rays?.Left >= _occlusion.MaxRays ? Estimate(camera, candidate, snapshot.Ego.Handle, rays)
                : default;
            Add(findings, camera, snapshot, candidate, occlusion);
        }
    }

    /// <summary>Adds what was found of a space to a frame's findings; where its object has an ignore region it needs none of its own.</summary>
    public void Add(FrameFindings findings, Camera camera, SceneSnapshot snapshot, FaceCandidate candidate, OcclusionEstimate occlusion)
    {
        LabelCandidate seen = candidate.Seen;
        int handle = seen.Entity.Handle;
        bool isParentMarked = findings.OcclusionOf(handle).Sight == Sight.Undetermined;
        findings.Add(
            RecordedOcclusion.Of(handle, candidate.Face.Number, seen.Id, occlusion, lights?.SetStateOf(handle, snapshot.GameFrame)),
            occlusion,
            LabelOf(camera, snapshot, candidate, occlusion),
            isParentMarked ? null : ObjectLabeller.RegionOf(camera, seen, occlusion));
    }

    /// <summary>Passes over a snapshot that is not labelled: the faces' numbers are remembered as if it were.</summary>
    public void Pass(Camera camera, SceneSnapshot snapshot)
    {
        foreach (FaceCandidate? _ in CandidatesOf(camera, snapshot))
        {
            // Being found gives a candidate its number.
        }
    }

    /// <summary>
    /// The faces of entities, numbered; null for one that is not in the image, and for a sign's seen that is seen from behind: there is
    /// nothing of it to see. The head of a light is a housing, and seen from all sides.
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
        return projection is { Box: { } box, AmodalBox: { } amodal } && options.IsLargeEnough(box)
            ? new FaceCandidate(face, new LabelCandidate(entity, registry.IdOf(entity, face.Number), cuboid, projection, box, amodal), registry.IdOf(entity))
            : null;
    }

    /// <summary>The label of a space in the image; null when it is not listed.</summary>
    public ObjectLabel? LabelOf(Camera camera, SceneSnapshot snapshot, FaceCandidate candidate, OcclusionEstimate occlusion)
    {
        (ModelFace face, LabelCandidate seen, int parent) = candidate;
        EntityState entity = seen.Entity;
        Cuboid cuboid = seen.Cuboid;
        if (!options.IsListed(occlusion))
        {
            return null;
        }

        return new ObjectLabel
        {
            Id = seen.Id,
            Class = face.Class,
            Model = entity.Model,
            Name = face.Name.Length == 0 ? null : face.Name,
            Parent = parent,
            Box2D = seen.Box,
            Box2DAmodal = seen.AmodalBox,
            TruncatedFraction = seen.Projection.TruncatedFraction,
            OccludedFraction = occlusion.Method == OcclusionMethod.None ? null : occlusion.OccludedFraction,
            OcclusionMethod = occlusion.Method,
            Box3D = cuboid,
            DistanceMetres = (cuboid.Centre - camera.Pose.Position).Length,
            Velocity = entity.Velocity,
            Face = new FaceLabel(
                face.Number,
                face.MutcdCode.Length == 0 ? null : face.MutcdCode,
                FacingAngleDegrees(face, cuboid, entity.Pose, camera.Pose.Position),
                face.Provenance,
                face.Class == ObjectClass.TrafficLight ? LightOf(entity, snapshot.GameFrame) : null),
        };
    }

    private OcclusionEstimate Estimate(Camera camera, FaceCandidate candidate, int egoHandle, IRayCaster caster)
    {
        LabelCandidate seen = candidate.Seen;
        int parent = seen.Entity.Handle;
        FaceRays rays = new(caster, parent, seen.Cuboid, MarginOf(candidate.Face));
        return _occlusion.Estimate(camera, seen.Cuboid, seen.Projection, parent, egoHandle, rays);
    }

    private static Vector3D MarginOf(ModelFace face)
    {
        double depth = face.Provenance == Provenance.Estimated ? EstimatedMarginMetres : MeasuredMarginMetres;
        double side = face.Class == ObjectClass.TrafficLight ? Math.Max(depth, BackplateMetres) : depth;
        return face.Facing is Facing.Left or Facing.Right ? new Vector3D(depth, side, side) : new Vector3D(side, depth, side);
    }

    private LightLabel LightOf(EntityState entity, long gameFrame) =>
        lights?.SetStateOf(entity.Handle, gameFrame) is { } state ? new LightLabel(state, LightMethod.Set, null) : LightLabel.Unknown;

    /// <summary>The angle between two directions by the tangent of its half, which is exact near 0 and 180 degrees as well. A camera in the middle of the seen sees it at 0.</summary>
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
