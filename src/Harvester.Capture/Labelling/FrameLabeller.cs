using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Makes the labels of one snapshot, phase by phase: objects, channels, faces, objects beyond the labelling range, lanes, joints, further
/// channels.
/// </summary>
/// <param name="options">What to label.</param>
/// <param name="rays">The ray caster; also that of <see cref="Lanes"/> and <see cref="Faces"/>.</param>
/// <param name="registry">The ids of the objects.</param>
internal sealed class FrameLabeller(LabellingOptions options, FrameRays rays, ObjectRegistry registry)
{
    private readonly ObjectLabeller _objects = new(options, registry);
    private readonly DistantLabeller _distant = new(options);
    private readonly JointLabeller _joints = new(options, rays);
    private readonly OcclusionEstimator _occlusion = new(options.OcclusionSamples);

    /// <summary>Labels the lanes; null to label none.</summary>
    public LaneLabeller? Lanes { get; init; }

    /// <summary>Compares masks of both methods; null if they are not compared.</summary>
    public MaskComparison? Comparison { get; init; }

    /// <summary>Labels faces of signs and heads of traffic lights; null to label none.</summary>
    public FaceLabeller? Faces { get; init; }

    /// <summary>Produces the parts of the channels.</summary>
    public IReadOnlyList<IChannelLabeller> Channels { get; init; } = [];

    /// <summary>Tells how much of each object the drawing hides; null to leave it open.</summary>
    public IDrawnOcclusion? DrawnOcclusion { get; init; }

    /// <summary>
    /// Labels a snapshot in steps. Each element is null until the work is done; the last is the result. The caller may pause after any step
    /// and continue in a later tick, as long as the game stands still.
    /// </summary>
    /// <param name="snapshot">The scene.</param>
    /// <param name="mayCastRays">
    /// Called before each object and each ray of a mask. If it returns false, an object has no occlusion and a mask gets no further rays.
    /// </param>
    /// <param name="pictures">The photographs for a coded mask; null if there are none.</param>
    public IEnumerable<FrameDraft?> Label(SceneSnapshot snapshot, Func<bool> mayCastRays, CodedPictures? pictures = null)
    {
        rays.Begin();
        Camera camera = options.CameraOf(snapshot.Camera);
        var draft = new FrameDraft(snapshot, camera);
        List<LabelCandidate> candidates = _objects.CandidatesOf(camera, snapshot);
        IEnumerable<bool> objects = options.Masks
            ? new MapLabeller(options, _objects, rays) { Comparison = Comparison }.Label(draft, candidates, mayCastRays, pictures)
            : LabelByRays(draft, candidates, mayCastRays);
        foreach (bool _ in objects)
        {
            yield return null;
        }

        foreach (bool _ in LabelChannels(ChannelTurn.AfterObjects, draft, mayCastRays))
        {
            yield return null;
        }

        rays.Begin(RayPhase.Faces);
        foreach (bool _ in Faces?.Label(draft, mayCastRays) ?? [])
        {
            yield return null;
        }

        rays.Begin(RayPhase.IgnoreRegions);
        foreach (DistantCandidate candidate in _distant.CandidatesOf(camera, snapshot.Distant))
        {
            Sight sight = Sight.NotAsked;
            if (mayCastRays() && rays.Left >= SightFinder.MaxRays)
            {
                foreach (Sight? step in _distant.LookInSteps(camera, candidate, snapshot.Ego.Handle, rays))
                {
                    if (step is null)
                    {
                        yield return null;
                    }

                    sight = step ?? sight;
                }
            }

            draft.Add(new DistantEntity(candidate.Entity, sight), DistantLabeller.RegionOf(camera, candidate, sight));
            yield return null;
        }

        rays.Begin(RayPhase.Lanes);
        foreach (LanesLabel? slice in Lanes?.Label(snapshot, camera, mayCastRays) ?? [])
        {
            draft.Lanes = slice;
            yield return null;
        }

        draft.Ids = registry.IdsOf(snapshot.Entities);
        rays.Begin(RayPhase.Joints);
        foreach (bool _ in _joints.Label(draft, mayCastRays))
        {
            yield return null;
        }

        foreach (bool _ in LabelChannels(ChannelTurn.Last, draft, mayCastRays))
        {
            yield return null;
        }

        if (DrawnOcclusion is { } drawn)
        {
            DrawnOcclusions.Add(draft, options.Image, drawn);
        }

        draft.Rays = rays.Counts;
        yield return draft;
    }

    /// <summary>The camera of a snapshot.</summary>
    public Camera CameraOf(SceneSnapshot snapshot) => options.CameraOf(snapshot.Camera);

    /// <summary>The objects of a snapshot that a mask may show, with the numbers that they have until it is finished.</summary>
    public IReadOnlyList<MapTarget> TargetsOf(SceneSnapshot snapshot) =>
        MapLabeller.TargetsOf(_objects.CandidatesOf(CameraOf(snapshot), snapshot));

    /// <summary>
    /// Passes over a snapshot that is not labelled. The state kept from frame to frame, the ids of objects and the road, is afterwards as
    /// if it had been labelled.
    /// </summary>
    public void Pass(SceneSnapshot snapshot)
    {
        Camera camera = options.CameraOf(snapshot.Camera);
        _objects.CandidatesOf(camera, snapshot);
        Faces?.Pass(camera, snapshot);
        Lanes?.Pass(snapshot);
    }

    private IEnumerable<bool> LabelChannels(ChannelTurn turn, FrameDraft draft, Func<bool> mayCastRays)
    {
        foreach (IChannelLabeller channel in Channels.Where(channel => channel.Turn == turn))
        {
            rays.Begin(channel.RaysKey);
            foreach (bool step in channel.Label(draft, mayCastRays))
            {
                yield return step;
            }
        }
    }

    private IEnumerable<bool> LabelByRays(FrameDraft draft, List<LabelCandidate> candidates, Func<bool> mayCastRays)
    {
        Camera camera = draft.Camera;
        int egoHandle = draft.Snapshot.Ego.Handle;
        rays.Begin(RayPhase.Occlusion);
        foreach (LabelCandidate candidate in candidates)
        {
            OcclusionEstimate occlusion = default;
            if (!options.IsWithinReach(camera, candidate.Cuboid))
            {
                occlusion = new OcclusionEstimate { Sight = Sight.Undetermined };
            }
            else if (mayCastRays() && rays.Left >= _occlusion.MaxRays)
            {
                foreach (
                    OcclusionEstimate? step in _occlusion.EstimateInSteps(
                        camera,
                        candidate.Cuboid,
                        candidate.Projection,
                        candidate.Entity.Handle,
                        egoHandle,
                        rays,
                        ObjectLabeller.IsOverlapped(camera, candidate, candidates)
                    )
                )
                {
                    if (step is null)
                    {
                        yield return true;
                    }

                    occlusion = step ?? default;
                }
            }

            draft.Add(
                RecordedOcclusion.Of(candidate.Entity.Handle, null, candidate.Id, occlusion, null),
                occlusion,
                _objects.LabelOf(camera, candidate, occlusion),
                ObjectLabeller.RegionOf(camera, candidate, occlusion)
            );
            yield return true;
        }
    }
}
