using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Depth;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Capture.Labelling;

/// <summary>A frame in progress: a scene, the camera that sees it, and what labelling finds.</summary>
/// <param name="snapshot">The state that the image shows.</param>
/// <param name="camera">The camera of the saved image.</param>
internal sealed class FrameDraft(SceneSnapshot snapshot, Camera camera)
{
    private readonly List<ObjectLabel> _objects = [];
    private readonly List<IgnoreRegion> _regions = [];
    private readonly List<RecordedOcclusion> _occlusions = [];
    private readonly List<DistantEntity> _distant = [];
    private readonly Dictionary<int, OcclusionEstimate> _entities = [];

    /// <summary>The state that the image shows.</summary>
    public SceneSnapshot Snapshot => snapshot;

    /// <summary>The camera of the saved image.</summary>
    public Camera Camera => camera;

    /// <summary>Game frames from reading the state to grabbing the image.</summary>
    public int LagFrames { get; set; }

    /// <summary>Game time from reading the state to grabbing the image, seconds.</summary>
    public double LagSeconds { get; set; }

    /// <summary>The instance map; null until there is one.</summary>
    public InstanceMap? Mask { get; set; }

    /// <summary>The class map; null until there is one.</summary>
    public InstanceMap? Classes { get; private set; }

    /// <summary>Where the class map comes from.</summary>
    public (SemanticsMethod Method, int RaysCast, int InterpolatedPixels) ClassSource { get; private set; }

    /// <summary>The depth maps; null until there are any.</summary>
    public DepthMaps? Depth { get; set; }

    /// <summary>The estimate behind the depth maps; null until there is one.</summary>
    public DepthMap? DepthEstimate { get; set; }

    /// <summary>The accuracy of the mask; null without one.</summary>
    public PixelMapLabel? PixelMap { get; set; }

    /// <summary>The lanes; null if no roads are known.</summary>
    public LanesLabel? Lanes { get; set; }

    /// <summary>The rays used; null for labels made without a game.</summary>
    public RayCounts? Rays { get; set; }

    /// <summary>The view of a rig that the frame is; null without a rig.</summary>
    public RigView? View { get; set; }

    /// <summary>The points of the LiDARs at its moment, if it is the first view.</summary>
    public IReadOnlyList<LidarSweep> Sweeps { get; set; } = [];

    /// <summary>
    /// The motion of the ego since the frame before; null if it is not recorded, or the frame is not a moment's first view.
    /// </summary>
    public IReadOnlyList<MotionSample>? Motion { get; set; }

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

    /// <summary>Takes the class map.</summary>
    public void Take(InstanceMap classes, SemanticsMethod method, int raysCast, int interpolatedPixels) =>
        (Classes, ClassSource) = (classes, (method, raysCast, interpolatedPixels));

    /// <summary>Replaces each object label by the result of a function.</summary>
    public void Update(Func<ObjectLabel, ObjectLabel> change)
    {
        for (int i = 0; i < _objects.Count; i++)
        {
            _objects[i] = change(_objects[i]);
        }
    }

    /// <summary>The label of the finished frame.</summary>
    /// <param name="frame">Its number in the session.</param>
    /// <param name="format">The format of the session's images.</param>
    /// <param name="places">The places of the session; null if it visits none.</param>
    public FrameLabel Label(int frame, ImageFormat format, PlaceSequence? places = null) => new(
        frame,
        snapshot.GameFrame,
        snapshot.TimeSeconds,
        LagFrames,
        LagSeconds,
        FramePaths.Image(frame, format, View?.Camera.Name),
        Mask is null ? null : FramePaths.Mask(frame, View?.Camera.Name),
        CameraLabel.Of(camera),
        EgoLabel.Of(snapshot.Ego),
        snapshot.Environment,
        Objects)
    {
        Moment = View?.MomentOf(frame),
        View = View?.Camera.Name,
        Lidar = [.. Sweeps.Select(sweep => new SweepLabel(
            sweep.Sensor, FramePaths.Sweep(frame, sweep.Sensor), sweep.Points.Count, sweep.RaysCast))],
        Motion = Motion,
        Place = places?.PlaceOf(frame),
        PlaceFrame = frame - places?.FirstFrameOf(places.PlaceOf(frame)),
        PixelMap = PixelMap,
        ClassMap = Classes is null ? null
            : new ClassMapLabel(
                FramePaths.Classes(frame, View?.Camera.Name),
                ClassSource.Method,
                ClassSource.RaysCast,
                ClassSource.InterpolatedPixels),
        Depth = DepthLabelOf(frame),
        Rays = Rays,
        IgnoreRegions = IgnoreRegions,
        Lanes = Lanes,
    };

    private DepthLabel? DepthLabelOf(int frame) => Depth is not { } maps ? null
        : new DepthLabel(
            FramePaths.Depth(frame, View?.Camera.Name),
            maps.Completed is null ? null : FramePaths.CompletedDepth(frame, View?.Camera.Name),
            maps.Error is null ? null : FramePaths.DepthError(frame, View?.Camera.Name),
            maps.RaysCast,
            maps.Sparse.Ids.Count(static depth => depth != 0));

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
