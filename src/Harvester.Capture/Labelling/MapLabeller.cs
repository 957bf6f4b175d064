using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Labels objects together with the instance mask that shows them.</summary>
internal sealed class MapLabeller(LabellingOptions options, ObjectLabeller objects, FrameRays rays)
{
    /// <summary>Labels the objects of a frame, in steps.</summary>
    /// <param name="draft">The frame; receives labels, occlusions and mask. Rays pass through the vehicle that carries its camera.</param>
    /// <param name="candidates">The objects.</param>
    /// <param name="mayCastRays">Called before each ray of the map, and before each object.</param>
    public IEnumerable<bool> Label(FrameDraft draft, List<LabelCandidate> candidates, Func<bool> mayCastRays)
    {
        Camera camera = draft.Camera;
        int egoHandle = draft.Snapshot.Ego.Handle;

        // Which objects are kept is known only after the map: until then they have consecutive numbers.
        MapTarget[] targets = [.. candidates.Select((candidate, index) =>
            new MapTarget(candidate.Entity.Handle, (ushort)(index + 1), candidate.Cuboid, candidate.Projection))];
        rays.Begin(RayPhase.Map);
        var mapOptions = new PixelMapOptions { RayBudget = rays.Left, RayReachMetres = options.RayReachMetres };
        var mapper = new AdaptivePixelMapper(camera, targets, egoHandle, rays, mapOptions);
        while (mayCastRays() && mapper.Step())
        {
            yield return true;
        }

        AdaptivePixelMap map = mapper.Finish();
        yield return true;

        rays.Begin(RayPhase.Occlusion);
        Box2D?[] bounds = InstanceBounds.Of(map.Map);
        var estimator = new MapOcclusionEstimator(camera, map.Map, egoHandle, rays, options.OcclusionSamples);
        var numbers = new ushort[targets.Length + 1];
        for (int i = 0; i < targets.Length; i++)
        {
            LabelCandidate candidate = candidates[i];
            ushort number = targets[i].Number;
            OcclusionEstimate occlusion = mayCastRays() && rays.Left >= options.OcclusionSamples
                ? estimator.Estimate(targets[i], map.Sights[number])
                : new OcclusionEstimate { Sight = map.Sights[number] };
            ObjectLabel? label = objects.LabelOf(camera, candidate, occlusion);
            numbers[number] = (ushort)(label?.Id ?? 0);
            draft.Add(
                RecordedOcclusion.Of(candidate.Entity.Handle, null, candidate.Id, occlusion, null),
                occlusion,
                label is null ? null : label with { Box2DVisible = bounds[number] },
                ObjectLabeller.RegionOf(camera, candidate, occlusion));
            yield return true;
        }

        for (int i = 0; i < map.Map.Ids.Length; i++)
        {
            map.Map.Ids[i] = numbers[map.Map.Ids[i]];
        }

        draft.Mask = map.Map;
        draft.PixelMap = new PixelMapLabel(map.ResolutionPixels, map.InterpolatedPixels, map.RaysCast);
    }
}
