using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Recomputes the labels of recorded scenes in order, with other options and without the game. Geometry is computed as in a harvest;
/// results of rays are kept where they still hold, and are undetermined elsewhere: docs/relabel.md.
/// </summary>
public sealed class FrameRelabeller
{
    private readonly LabellingOptions _options;
    private readonly LabellingOptions _recordedOptions;
    private readonly ObjectRegistry _registry;
    private readonly ObjectLabeller _objects;
    private readonly RecordedLights _lights = new();
    private readonly DistantLabeller _distant;
    private readonly FaceLabeller? _faces;
    private readonly LaneLabeller? _lanes;
    private readonly bool _hasPaint;

    /// <summary>Prepares for the scenes of one session.</summary>
    /// <param name="options">What to label; the lens applies to all frames.</param>
    /// <param name="recordedOptions">The options of the harvest; its lens is that of each scene.</param>
    /// <param name="ids">The object ids of all scenes of the session.</param>
    /// <param name="roads">The roads to measure lanes on; null to keep the recorded lanes.</param>
    /// <param name="paint">The paint on these roads; null to keep the recorded markings.</param>
    public FrameRelabeller(
        LabellingOptions options,
        LabellingOptions recordedOptions,
        RecordedIds ids,
        IRoads? roads,
        IRoadPaint? paint = null
    )
    {
        _options = options ?? throw new ArgumentNullException(nameof(options));
        _recordedOptions = recordedOptions ?? throw new ArgumentNullException(nameof(recordedOptions));
        _registry = new ObjectRegistry((ids ?? throw new ArgumentNullException(nameof(ids))).Greatest + 1) { Recorded = ids };
        _objects = new ObjectLabeller(options, _registry);
        _distant = new DistantLabeller(options);
        _faces = options.Faces is { } table ? new FaceLabeller(table, options, null, _lights, _registry) : null;
        _lanes = roads is null ? null : new LaneLabeller(roads, paint, null, _registry);
        _hasPaint = paint is not null;
    }

    /// <summary>
    /// Whether a frame's mask still holds. Rays were cast through the lens of the harvest, so with another lens the pixels differ; a mask
    /// of another tool was made from the image itself.
    /// </summary>
    /// <param name="scene">The frame's scene.</param>
    /// <param name="recorded">The label of the harvest.</param>
    /// <param name="lens">The lens for the new label.</param>
    public static bool KeepsMask(RecordedScene scene, FrameLabel recorded, Lens lens) =>
        recorded?.Mask is not null && (scene?.Lens == lens || recorded.PixelMap is null);

    /// <summary>Recomputes the label of a frame.</summary>
    /// <param name="scene">The frame's scene.</param>
    /// <param name="recorded">The label of the harvest.</param>
    /// <param name="picture">Reads the frame's image; called if the state of a light is to be found in it.</param>
    /// <exception cref="HarvestFaultException">All object ids are used up.</exception>
    public FrameLabel Relabel(RecordedScene scene, FrameLabel recorded, Func<PixelBuffer> picture)
    {
        if (scene is null)
        {
            throw new ArgumentNullException(nameof(scene));
        }

        if (recorded is null)
        {
            throw new ArgumentNullException(nameof(recorded));
        }

        Lens lens = LensOf(scene, recorded);
        bool isLensSame = scene.Lens == lens;
        bool keepsMask = KeepsMask(scene, recorded, lens);
        SceneSnapshot snapshot = Begin(scene, recorded, out Camera camera);
        var occlusions = new RecordedOcclusions(scene, recorded, _recordedOptions, isLensSame);
        var draft = new FrameDraft(snapshot, camera, _objects.CandidatesOf(camera, snapshot));
        foreach (LabelCandidate candidate in draft.Candidates)
        {
            OcclusionEstimate occlusion = occlusions.Of(candidate);
            ObjectLabel? label = _objects.LabelOf(camera, candidate, occlusion);
            draft.Add(
                RecordedOcclusion.Of(candidate.Entity.Handle, null, candidate.Id, occlusion, null),
                occlusion,
                label is null
                    ? null
                    : label with
                    {
                        TrueOccludedFraction = isLensSame ? occlusions.LabelOf(label.Id)?.TrueOccludedFraction : null,
                        Box2DVisible = keepsMask ? occlusions.LabelOf(label.Id)?.Box2DVisible : null,
                        AmodalMask = keepsMask ? occlusions.LabelOf(label.Id)?.AmodalMask : null,
                        Joints = candidate.Entity.Skeleton is { } skeleton
                            ? JointLabels.Again(camera, skeleton, occlusions.LabelOf(label.Id)?.Joints)
                            : null,
                    },
                ObjectLabeller.RegionOf(camera, candidate, occlusion)
            );
        }

        foreach (FaceCandidate candidate in (_faces?.CandidatesOf(camera, snapshot) ?? []).OfType<FaceCandidate>())
        {
            _faces!.Add(draft, candidate, occlusions.Of(candidate));
        }

        foreach (DistantEntity distant in DistantIn(scene))
        {
            foreach (DistantCandidate candidate in _distant.CandidatesOf(camera, [distant.Entity]))
            {
                draft.Add(distant, DistantLabeller.RegionOf(camera, candidate, distant.Sight));
            }
        }

        if (LightObserver.NeedsPicture(draft))
        {
            LightObserver.Observe(draft, picture());
        }

        LanesLabel? lanes = LanesOf(draft, recorded, isLensSame);
        return recorded with
        {
            Mask = keepsMask ? recorded.Mask : null,
            PixelMap = keepsMask ? recorded.PixelMap : null,
            Channels = isLensSame ? recorded.Channels : recorded.Channels.WithoutLens(),
            Camera = CameraLabel.Of(camera),
            Ego = EgoLabel.Of(snapshot.Ego),
            Objects = draft.Objects,
            IgnoreRegions = draft.IgnoreRegions,
            Lanes = lanes,
        };
    }

    /// <summary>Passes over a scene of another shard; ids and road are kept as if it had been labelled.</summary>
    /// <param name="scene">The frame's scene.</param>
    /// <param name="recorded">The label of the harvest.</param>
    /// <exception cref="HarvestFaultException">All object ids are used up.</exception>
    public void Pass(RecordedScene scene, FrameLabel recorded)
    {
        if (scene is null)
        {
            throw new ArgumentNullException(nameof(scene));
        }

        if (recorded is null)
        {
            throw new ArgumentNullException(nameof(recorded));
        }

        SceneSnapshot snapshot = Begin(scene, recorded, out Camera camera);
        _objects.CandidatesOf(camera, snapshot);
        _faces?.Pass(camera, snapshot);
        _lanes?.Pass(snapshot);
    }

    /// <summary>The lens of a frame: that of its camera for a view of a rig, otherwise the one for all frames.</summary>
    private Lens LensOf(RecordedScene scene, FrameLabel recorded) => recorded.View is null ? _options.Lens : scene.Lens;

    private SceneSnapshot Begin(RecordedScene scene, FrameLabel recorded, out Camera camera)
    {
        _registry.Remember(scene);
        _lights.Show(scene);
        LabellingOptions options = recorded.View is null
            ? _options
            : _options with
            {
                Image = new ImageSize(recorded.Camera.Width, recorded.Camera.Height),
                Lens = scene.Lens,
            };
        camera = options.CameraOf(scene.Snapshot.Camera);
        return scene.Snapshot with
        {
            Entities = [.. scene.Snapshot.Entities.Where(entity => _options.IsInRange(scene.Snapshot.Camera, entity))],
        };
    }

    private IEnumerable<DistantEntity> DistantIn(RecordedScene scene)
    {
        Dictionary<int, Sight> sights = scene
            .Occlusions.Where(found => found.Face is null)
            .ToDictionary(found => found.Handle, found => found.Sight);
        return scene
            .Snapshot.Entities.Where(entity => !_options.IsInRange(scene.Snapshot.Camera, entity))
            .Select(entity => new DistantEntity(entity, sights.TryGetValue(entity.Handle, out Sight sight) ? sight : Sight.NotAsked))
            .Concat(scene.Distant);
    }

    /// <summary>The lanes of a frame; names those of its vehicles too.</summary>
    private LanesLabel? LanesOf(FrameDraft draft, FrameLabel frame, bool isLensSame)
    {
        LanesLabel? recorded = frame.Lanes is null || isLensSame ? frame.Lanes : RecordedLanes.SeenBy(draft.Camera, frame.Lanes);
        if (_lanes is null)
        {
            var known = frame.Objects.ToLookup(label => label.Id);
            draft.Update(label =>
                known[label.Id].FirstOrDefault() is { } before
                    ? label with
                    {
                        LaneId = before.LaneId,
                        GovernedLanes = before.GovernedLanes,
                    }
                    : label
            );
            return recorded;
        }

        WorkRun.Complete(_lanes.Label(draft, static () => false));
        if (draft.Lanes is not { } lanes)
        {
            return null;
        }

        LanesLabel completed = RecordedLanes.Completed(lanes, recorded);
        return _hasPaint ? completed with { Markings = lanes.Markings } : completed;
    }
}
