using Harvester.Capture.Events;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>
/// A frame in progress: a scene, the camera that sees it, its picture, and what labelling finds. Photographs and labels of a frame use the
/// same candidates, so that the numbers of the objects in both agree.
/// </summary>
/// <param name="snapshot">The state that the image shows.</param>
/// <param name="camera">The camera of the saved image.</param>
/// <param name="candidates">The objects that may be labelled.</param>
internal sealed class FrameDraft(SceneSnapshot snapshot, Camera camera, List<LabelCandidate> candidates)
{
    private MapTarget[]? _targets;
    private readonly List<ObjectLabel> _objects = [];
    private readonly List<IgnoreRegion> _regions = [];
    private readonly List<RecordedOcclusion> _occlusions = [];
    private readonly List<DistantEntity> _distant = [];
    private readonly Dictionary<int, OcclusionEstimate> _entities = [];
    private readonly List<FramePart> _parts = [];

    /// <summary>The state that the image shows.</summary>
    public SceneSnapshot Snapshot => snapshot;

    /// <summary>The camera of the saved image.</summary>
    public Camera Camera => camera;

    /// <summary>The objects that may be labelled.</summary>
    public List<LabelCandidate> Candidates => candidates;

    /// <summary>
    /// The candidates as targets of a mask, in their order. Which objects are kept is known only after the mask, so until then they have
    /// consecutive numbers from 1.
    /// </summary>
    public IReadOnlyList<MapTarget> Targets =>
        _targets ??= [
            .. candidates.Select(
                (candidate, index) => new MapTarget(candidate.Entity.Handle, (ushort)(index + 1), candidate.Cuboid, candidate.Projection)
            ),
        ];

    /// <summary>Its number in the session; 0 for labels made without a game.</summary>
    public int Number { get; init; }

    /// <summary>Number of the frame of the same view before it at the same place; null for the first.</summary>
    public int? Before { get; init; }

    /// <summary>Whether the frame was not discarded; known only after it was labelled.</summary>
    public bool IsKept { get; set; }

    /// <summary>The image; null until it is grabbed, and for labels made without a game.</summary>
    public GrabbedPicture? Picture { get; set; }

    /// <summary>Game frames from reading the state to grabbing the image.</summary>
    public int LagFrames { get; set; }

    /// <summary>Game time from reading the state to grabbing the image, seconds.</summary>
    public double LagSeconds { get; set; }

    /// <summary>The instance map; null until there is one.</summary>
    public InstanceMap? Mask { get; set; }

    /// <summary>The accuracy of the mask; null without one.</summary>
    public PixelMapLabel? PixelMap { get; set; }

    /// <summary>The lanes; null if no roads are known.</summary>
    public LanesLabel? Lanes { get; set; }

    /// <summary>The rays used; null for labels made without a game.</summary>
    public RayCounts? Rays { get; set; }

    /// <summary>The view of a rig that the frame is; null without a rig.</summary>
    public RigView? View { get; set; }

    /// <summary>What the channels have found so far.</summary>
    public IReadOnlyList<FramePart> Parts => _parts;

    /// <summary>
    /// The motion of the ego since the frame before; null if it is not recorded, or the frame is not a moment's first view.
    /// </summary>
    public IReadOnlyList<MotionSample>? Motion { get; set; }

    /// <summary>The events that are open at its moment; null if events are not recorded.</summary>
    public IReadOnlyList<EventMark>? Events { get; set; }

    /// <summary>The events that have ended since the frame before; empty in all but the first view of a moment.</summary>
    public IReadOnlyList<DrivingEvent> EndedEvents { get; set; } = [];

    /// <summary>The events that are open at its moment or have ended since the frame before, with their times.</summary>
    public IReadOnlyList<EventSpan> Spans { get; set; } = [];

    /// <summary>The ids of the entities that have one, by handle.</summary>
    public IReadOnlyDictionary<int, int> Ids { get; set; } = new Dictionary<int, int>();

    /// <summary>The objects in the image, in the order of their ids.</summary>
    public IReadOnlyList<ObjectLabel> Objects => [.. _objects.OrderBy(label => label.Id)];

    /// <summary>Regions of objects without a label, the nearest first.</summary>
    public IReadOnlyList<IgnoreRegion> IgnoreRegions => [.. _regions.OrderBy(region => region.DistanceMetres)];

    /// <summary>The occlusion of each entity and face in the image, for the scene.</summary>
    public IReadOnlyList<RecordedOcclusion> Occlusions => _occlusions;

    /// <summary>The entities beyond the labelling range that are in the image.</summary>
    public IReadOnlyList<DistantEntity> Distant => _distant;

    /// <summary>The occlusion of an entity in the image; the default, not examined, if it has none.</summary>
    public OcclusionEstimate OcclusionOf(int handle) => _entities.TryGetValue(handle, out OcclusionEstimate found) ? found : default;

    /// <summary>Adds an entity or one of its faces.</summary>
    /// <param name="found">Its occlusion, as recorded in the scene.</param>
    /// <param name="estimate">Its occlusion as an estimate.</param>
    /// <param name="label">Its label; null if it is not listed.</param>
    /// <param name="region">Its ignore region; null if there is none.</param>
    public void Add(RecordedOcclusion found, OcclusionEstimate estimate, ObjectLabel? label, IgnoreRegion? region)
    {
        _occlusions.Add(found);
        if (found.Face is null)
        {
            _entities[found.Handle] = estimate;
        }

        List(label, region);
    }

    /// <summary>Adds an entity beyond the labelling range.</summary>
    public void Add(DistantEntity found, IgnoreRegion? region)
    {
        _distant.Add(found);
        List(null, region);
    }

    /// <summary>Adds what a channel has found.</summary>
    public void Add(FramePart part) => _parts.Add(part);

    /// <summary>What one channel has found; null if that is nothing, or nothing yet.</summary>
    public T? Part<T>()
        where T : FramePart => _parts.OfType<T>().FirstOrDefault();

    /// <summary>Replaces each object label by the result of a function.</summary>
    public void Update(Func<ObjectLabel, ObjectLabel> change)
    {
        for (int i = 0; i < _objects.Count; i++)
        {
            _objects[i] = change(_objects[i]);
        }
    }

    private void List(ObjectLabel? label, IgnoreRegion? region)
    {
        if (label is not null)
        {
            _objects.Add(label);
        }

        if (region is not null)
        {
            _regions.Add(region);
        }
    }
}
