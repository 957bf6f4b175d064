using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
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

    /// <summary>Finds out what follows from a snapshot alone.</summary>
    public PreparedFrame Prepare(SceneSnapshot snapshot)
    {
        Camera camera = options.CameraOf(snapshot.Camera);
        return new PreparedFrame(new FrameDraft(snapshot, camera), _objects.CandidatesOf(camera, snapshot));
    }

    /// <summary>
    /// Labels a frame in steps, into its draft. The work may be interrupted after any step and go on in a later tick, as long as the game
    /// stands still.
    /// </summary>
    /// <param name="frame">The frame.</param>
    /// <param name="mayCastRays">
    /// Called before each object and each ray of a mask. If it returns false, an object has no occlusion and a mask gets no further rays.
    /// </param>
    /// <param name="pictures">The photographs for a coded mask; null if there are none.</param>
    public IEnumerable<WorkStep> Label(PreparedFrame frame, Func<bool> mayCastRays, CodedPictures? pictures = null)
    {
        rays.Begin();
        (FrameDraft draft, SceneSnapshot snapshot) = (frame.Draft, frame.Snapshot);
        yield return WorkStep.Do(
            options.Masks
                ? new MapLabeller(options, _objects, rays) { Comparison = Comparison }.Label(frame, mayCastRays, pictures)
                : LabelByRays(frame, mayCastRays)
        );
        yield return WorkStep.Do(LabelChannels(ChannelTurn.AfterObjects, draft, mayCastRays));
        if (Faces is not null)
        {
            rays.Begin(RayPhase.Faces);
            yield return WorkStep.Do(Faces.Label(draft, mayCastRays));
        }

        yield return WorkStep.Do(LookAtDistant(frame, mayCastRays));
        if (Lanes is not null)
        {
            rays.Begin(RayPhase.Lanes);
            yield return WorkStep.Do(Lanes.Label(draft, mayCastRays));
        }

        draft.Ids = registry.IdsOf(snapshot.Entities);
        rays.Begin(RayPhase.Joints);
        yield return WorkStep.Do(_joints.Label(draft, mayCastRays));
        yield return WorkStep.Do(LabelChannels(ChannelTurn.Last, draft, mayCastRays));
        if (DrawnOcclusion is { } drawn)
        {
            DrawnOcclusions.Add(draft, options.Image, drawn);
        }

        draft.Rays = rays.Counts;
    }

    /// <summary>Labels a snapshot in the tick in hand.</summary>
    /// <param name="snapshot">The scene.</param>
    /// <param name="mayCastRays">As for <see cref="Label"/>.</param>
    public FrameDraft LabelAtOnce(SceneSnapshot snapshot, Func<bool> mayCastRays)
    {
        PreparedFrame frame = Prepare(snapshot);
        WorkRun.Complete(Label(frame, mayCastRays));
        return frame.Draft;
    }

    /// <summary>
    /// Passes over a frame that is not labelled. The state kept from frame to frame, the ids of objects and the road, is afterwards as if
    /// it had been labelled.
    /// </summary>
    public void Pass(PreparedFrame frame)
    {
        Faces?.Pass(frame.Camera, frame.Snapshot);
        Lanes?.Pass(frame.Snapshot);
    }

    private IEnumerable<WorkStep> LookAtDistant(PreparedFrame frame, Func<bool> mayCastRays)
    {
        (FrameDraft draft, SceneSnapshot snapshot, Camera camera) = (frame.Draft, frame.Snapshot, frame.Camera);
        var found = new WorkResult<Sight>();
        rays.Begin(RayPhase.IgnoreRegions);
        foreach (DistantCandidate candidate in _distant.CandidatesOf(camera, snapshot.Distant))
        {
            Sight sight = Sight.NotAsked;
            if (mayCastRays() && rays.Left >= SightFinder.MaxRays)
            {
                yield return WorkStep.Do(_distant.LookInSteps(camera, candidate, snapshot.Ego.Handle, rays, found));
                sight = found.Value;
            }

            draft.Add(new DistantEntity(candidate.Entity, sight), DistantLabeller.RegionOf(camera, candidate, sight));
            yield return WorkStep.Pause;
        }
    }

    private IEnumerable<WorkStep> LabelChannels(ChannelTurn turn, FrameDraft draft, Func<bool> mayCastRays)
    {
        foreach (IChannelLabeller channel in Channels.Where(channel => channel.Turn == turn))
        {
            rays.Begin(channel.RaysKey);
            yield return WorkStep.Do(channel.Label(draft, mayCastRays));
        }
    }

    private IEnumerable<WorkStep> LabelByRays(PreparedFrame frame, Func<bool> mayCastRays)
    {
        (FrameDraft draft, Camera camera, List<LabelCandidate> candidates) = (frame.Draft, frame.Camera, frame.Candidates);
        int egoHandle = frame.Snapshot.Ego.Handle;
        var estimate = new WorkResult<OcclusionEstimate>();
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
                yield return WorkStep.Do(
                    _occlusion.EstimateInSteps(
                        camera,
                        candidate.Cuboid,
                        candidate.Projection,
                        candidate.Entity.Handle,
                        egoHandle,
                        rays,
                        estimate,
                        ObjectLabeller.IsOverlapped(camera, candidate, candidates)
                    )
                );
                occlusion = estimate.Value;
            }

            draft.Add(
                RecordedOcclusion.Of(candidate.Entity.Handle, null, candidate.Id, occlusion, null),
                occlusion,
                _objects.LabelOf(camera, candidate, occlusion),
                ObjectLabeller.RegionOf(camera, candidate, occlusion)
            );
            yield return WorkStep.Pause;
        }
    }
}
