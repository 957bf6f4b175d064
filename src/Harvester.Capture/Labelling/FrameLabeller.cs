using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the labels of the objects of one snapshot: boxes by geometry, occlusion and masks by rays.</summary>
internal sealed class FrameLabeller(HarvestOptions options, IRayCaster rays, ObjectRegistry registry)
{
    private readonly ObjectLabeller _objects = new(options, registry);
    private readonly List<RecordedOcclusion> _found = [];
    private readonly OcclusionEstimator _occlusion = new(options.OcclusionSamples);
    private readonly PixelMapOptions _mapOptions = new() { RayBudget = options.MaskRayBudget, RayReachMetres = options.RayReachMetres };

    /// <summary>Labels the lanes; null for labels without.</summary>
    public LaneLabeller? Lanes { get; init; }

    /// <summary>Labels the parts of objects that matter; null for labels without.</summary>
    public SpaceLabeller? Spaces { get; init; }

    /// <summary>The camera of the saved image.</summary>
    public static Camera CameraOf(HarvestOptions options, CameraState state) =>
        new(state.Pose, new CameraIntrinsics(state.VerticalFovDegrees, options.Image, state.WindowAspect, state.NearClip, options.Lens));

    /// <summary>
    /// Labels a snapshot a slice at a time. Each element is null until the work is done; the last is the result.
    /// The caller may leave off after any slice and go on in a later tick, as long as the game stands still.
    /// </summary>
    /// <param name="snapshot">The scene.</param>
    /// <param name="mayCastRays">Asked for each object and each ray of a mask; objects that get a no have no occlusion, and a mask ends there.</param>
    public IEnumerable<FrameLabelling?> Label(SceneSnapshot snapshot, Func<bool> mayCastRays)
    {
        _found.Clear();
        Camera camera = CameraOf(options, snapshot.Camera);
        List<LabelCandidate> candidates = _objects.CandidatesOf(camera, snapshot);
        FrameLabelling? objects = null;
        foreach (FrameLabelling? slice in options.Masks
            ? LabelByMap(camera, snapshot.Ego.Handle, candidates, mayCastRays)
            : LabelByRays(camera, snapshot.Ego.Handle, candidates, mayCastRays))
        {
            objects = slice;
            yield return null;
        }

        var spaces = new List<ObjectLabel>();
        foreach (ObjectLabel? space in Spaces?.Label(camera, snapshot, _found, mayCastRays) ?? [])
        {
            if (space is not null)
            {
                spaces.Add(space);
            }

            yield return null;
        }

        LanesLabel? lanes = null;
        foreach (LanesLabel? slice in Lanes?.Label(snapshot, camera, mayCastRays) ?? [])
        {
            lanes = slice;
            yield return null;
        }

        yield return objects! with
        {
            Objects = [.. objects.Objects.Concat(spaces).OrderBy(label => label.Id)],
            Lanes = lanes,
            Ids = registry.IdsOf(snapshot.Entities),
            Occlusions = [.. _found],
        };
    }

    /// <summary>
    /// Passes over a snapshot that is not labelled. What labelling remembers from frame to frame, the objects' numbers and the road, is
    /// afterwards as if it had been.
    /// </summary>
    public void Pass(SceneSnapshot snapshot)
    {
        Camera camera = CameraOf(options, snapshot.Camera);
        _objects.CandidatesOf(camera, snapshot);
        Spaces?.Pass(camera, snapshot);
        Lanes?.Pass(snapshot);
    }

    private IEnumerable<FrameLabelling?> LabelByRays(
        Camera camera, int egoHandle, List<LabelCandidate> candidates, Func<bool> mayCastRays)
    {
        var objects = new List<ObjectLabel>();
        foreach (LabelCandidate candidate in candidates)
        {
            OcclusionEstimate occlusion = mayCastRays()
                ? _occlusion.Estimate(camera, candidate.Cuboid, candidate.Projection, candidate.Entity.Handle, egoHandle, rays)
                : default;
            _found.Add(new RecordedOcclusion(candidate.Entity.Handle, null, candidate.Id, occlusion.Method, occlusion.OccludedFraction, null));
            if (_objects.LabelOf(camera, candidate, occlusion) is { } label)
            {
                objects.Add(label);
            }

            yield return null;
        }

        objects.Sort(static (a, b) => a.Id.CompareTo(b.Id));
        yield return new FrameLabelling(objects, null);
    }

    // Which objects are kept is known only after the map: until then they are numbered through.
    private IEnumerable<FrameLabelling?> LabelByMap(
        Camera camera, int egoHandle, List<LabelCandidate> candidates, Func<bool> mayCastRays)
    {
        MapTarget[] targets = [.. candidates.Select((candidate, index) =>
            new MapTarget(candidate.Entity.Handle, (ushort)(index + 1), candidate.Cuboid, candidate.Projection))];
        var mapper = new AdaptivePixelMapper(camera, targets, egoHandle, rays, _mapOptions);
        while (mayCastRays() && mapper.Step())
        {
            yield return null;
        }

        AdaptivePixelMap map = mapper.Finish();
        yield return null;

        var estimator = new MapOcclusionEstimator(camera, map.Map, egoHandle, rays, options.OcclusionSamples);
        var objects = new List<ObjectLabel>();
        var numbers = new ushort[targets.Length + 1];
        for (int i = 0; i < targets.Length; i++)
        {
            OcclusionEstimate occlusion = mayCastRays() ? estimator.Estimate(targets[i], map.Methods[targets[i].Number]) : default;
            _found.Add(new RecordedOcclusion(candidates[i].Entity.Handle, null, candidates[i].Id, occlusion.Method, occlusion.OccludedFraction, null));
            if (_objects.LabelOf(camera, candidates[i], occlusion) is { } label)
            {
                objects.Add(label);
                numbers[targets[i].Number] = (ushort)label.Id;
            }

            yield return null;
        }

        for (int i = 0; i < map.Map.Ids.Length; i++)
        {
            map.Map.Ids[i] = numbers[map.Map.Ids[i]];
        }

        Box2D?[] bounds = InstanceBounds.Of(map.Map);
        objects.Sort(static (a, b) => a.Id.CompareTo(b.Id));
        yield return new FrameLabelling([.. objects.Select(label => label with { Box2DVisible = bounds[label.Id] })], map.Map)
        {
            PixelMap = new PixelMapLabel(map.ResolutionPixels, map.InterpolatedPixels, map.RaysCast),
        };
    }
}
