using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
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

    /// <summary>The camera of the saved image.</summary>
    public Camera CameraOf(SceneSnapshot snapshot) => options.CameraOf(snapshot.Camera);

    /// <summary>The objects that may be labelled, found before anything is photographed or a ray is cast.</summary>
    public List<LabelCandidate> CandidatesOf(Camera camera, SceneSnapshot snapshot)
    {
        if (options.Channels.Contains(FrameChannels.Occupancy.Key))
        {
            OccupancyLabeller.AssignIds(snapshot, registry);
        }

        return _objects.CandidatesOf(camera, snapshot);
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
    public IEnumerable<WorkStep> Label(FrameDraft frame, Func<bool> mayCastRays, CodedPictures? pictures = null)
    {
        rays.Begin();
        MaskedObjects? masked = null;
        if (options.Masks)
        {
            var made = new WorkResult<MadeMap>();
            yield return WorkStep.Do(new MaskMaker(options, rays) { Comparison = Comparison }.Make(frame, mayCastRays, pictures, made));
            masked = new MaskedObjects(frame, made.Value!, options.OcclusionSamples, rays);
        }

        // Objects: the occlusion of each from the mask, otherwise from rays of its own; then its label.
        rays.Begin(RayPhase.Occlusion);
        var estimate = new WorkResult<OcclusionEstimate>();
        for (int i = 0; i < frame.Candidates.Count; i++)
        {
            LabelCandidate candidate = frame.Candidates[i];
            OcclusionEstimate occlusion = default;
            if (masked is not null)
            {
                occlusion = masked.OcclusionOf(i, mayCastRays());
            }
            else if (!options.IsWithinReach(frame.Camera, candidate.Cuboid))
            {
                occlusion = new OcclusionEstimate { Sight = Sight.Undetermined };
            }
            else if (mayCastRays() && rays.Left >= _occlusion.MaxRays)
            {
                yield return WorkStep.Do(
                    _occlusion.EstimateInSteps(
                        frame.Camera,
                        candidate.Cuboid,
                        candidate.Projection,
                        candidate.Entity.Handle,
                        frame.Snapshot.Ego.Handle,
                        rays,
                        estimate,
                        ObjectLabeller.IsOverlapped(frame.Camera, candidate, frame.Candidates)
                    )
                );
                occlusion = estimate.Value;
            }

            ObjectLabel? label = _objects.LabelOf(frame.Camera, candidate, occlusion);
            frame.Add(
                RecordedOcclusion.Of(candidate.Entity.Handle, null, candidate.Id, occlusion, null),
                occlusion,
                masked is null ? label : masked.Completed(i, label),
                ObjectLabeller.RegionOf(frame.Camera, candidate, occlusion)
            );
            yield return WorkStep.Pause;
        }

        masked?.AddMask();

        yield return WorkStep.Do(LabelChannels(ChannelTurn.AfterObjects, frame, mayCastRays));
        if (Faces is not null)
        {
            rays.Begin(RayPhase.Faces);
            yield return WorkStep.Do(Faces.Label(frame, mayCastRays));
        }

        yield return WorkStep.Do(LookAtDistant(frame, mayCastRays));
        if (Lanes is not null)
        {
            rays.Begin(RayPhase.Lanes);
            yield return WorkStep.Do(Lanes.Label(frame, mayCastRays));
        }

        frame.Ids = registry.IdsOf(frame.Snapshot.Entities);
        rays.Begin(RayPhase.Joints);
        yield return WorkStep.Do(_joints.Label(frame, mayCastRays));
        yield return WorkStep.Do(LabelChannels(ChannelTurn.Last, frame, mayCastRays));
        if (DrawnOcclusion is { } drawn)
        {
            DrawnOcclusions.Add(frame, options.Image, drawn);
        }

        frame.Rays = rays.Counts;
    }

    /// <summary>Labels a snapshot in the tick in hand.</summary>
    /// <param name="snapshot">The scene.</param>
    /// <param name="mayCastRays">As for <see cref="Label"/>.</param>
    public FrameDraft LabelAtOnce(SceneSnapshot snapshot, Func<bool> mayCastRays)
    {
        Camera camera = CameraOf(snapshot);
        var frame = new FrameDraft(snapshot, camera, CandidatesOf(camera, snapshot));
        WorkRun.Complete(Label(frame, mayCastRays));
        return frame;
    }

    /// <summary>
    /// Passes over a frame that is not labelled. The state kept from frame to frame, the ids of objects and the road, is afterwards as if
    /// it had been labelled.
    /// </summary>
    public void Pass(FrameDraft frame)
    {
        Faces?.Pass(frame.Camera, frame.Snapshot);
        Lanes?.Pass(frame.Snapshot);
    }

    private IEnumerable<WorkStep> LookAtDistant(FrameDraft draft, Func<bool> mayCastRays)
    {
        (SceneSnapshot snapshot, Camera camera) = (draft.Snapshot, draft.Camera);
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
}
