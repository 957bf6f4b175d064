using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>Labels objects together with the instance mask that shows them.</summary>
internal sealed class MapLabeller(LabellingOptions options, ObjectLabeller objects, FrameRays rays)
{
    /// <summary>Compares masks of both methods; null if they are not compared.</summary>
    public MaskComparison? Comparison { get; init; }

    /// <summary>Labels the objects of a frame, in steps.</summary>
    /// <param name="frame">The frame; its draft receives labels, occlusions and mask. Rays pass through the camera's vehicle.</param>
    /// <param name="mayCastRays">Called before each ray of the map, and before each object.</param>
    /// <param name="pictures">The photographs for a coded mask; null for a mask from rays.</param>
    public IEnumerable<WorkStep> Label(PreparedFrame frame, Func<bool> mayCastRays, CodedPictures? pictures = null)
    {
        (FrameDraft draft, Camera camera, List<LabelCandidate> candidates) = (frame.Draft, frame.Camera, frame.Candidates);
        IReadOnlyList<MapTarget> targets = frame.Targets;
        int egoHandle = frame.Snapshot.Ego.Handle;
        rays.Begin(RayPhase.Map);
        MadeMap? coded = null;
        if (pictures is not null)
        {
            var maker = new CodedMapMaker(options, camera, targets, egoHandle, rays, pictures);
            yield return WorkStep.Do(maker.Make(mayCastRays));
            coded = maker.Made;
        }

        MadeMap? fromRays = null;
        if (coded is null || Comparison is not null)
        {
            var mapper = new AdaptivePixelMapper(
                camera,
                targets,
                egoHandle,
                rays,
                new PixelMapOptions { RayBudget = rays.Left, RayReachMetres = options.RayReachMetres }
            );
            while (mayCastRays() && mapper.Step())
            {
                yield return WorkStep.Pause;
            }

            fromRays = MadeMap.Of(mapper.Finish());
        }

        MadeMap map = coded ?? fromRays!;
        if (coded is not null && fromRays is not null)
        {
            Comparison!.Add(candidates, coded.Map, fromRays.Map);
        }

        yield return WorkStep.Pause;

        rays.Begin(RayPhase.Occlusion);
        Box2D?[] bounds = InstanceBounds.Of(map.Map);
        var estimator = new MapOcclusionEstimator(camera, map.Map, egoHandle, rays, options.OcclusionSamples);
        var numbers = new ushort[targets.Count + 1];
        for (int i = 0; i < targets.Count; i++)
        {
            LabelCandidate candidate = candidates[i];
            ushort number = targets[i].Number;
            OcclusionEstimate occlusion =
                mayCastRays() && rays.Left >= options.OcclusionSamples
                    ? estimator.Estimate(targets[i], map.Sights[number])
                    : new OcclusionEstimate { Sight = map.Sights[number] };
            ObjectLabel? label = objects.LabelOf(camera, candidate, occlusion);
            numbers[number] = (ushort)(label?.Id ?? 0);
            draft.Add(
                RecordedOcclusion.Of(candidate.Entity.Handle, null, candidate.Id, occlusion, null),
                occlusion,
                label is null ? null : label with { Box2DVisible = bounds[number], AmodalMask = map.AmodalOf(number) },
                ObjectLabeller.RegionOf(camera, candidate, occlusion)
            );
            yield return WorkStep.Pause;
        }

        for (int i = 0; i < map.Map.Ids.Length; i++)
        {
            map.Map.Ids[i] = numbers[map.Map.Ids[i]];
        }

        draft.Mask = map.Map;
        draft.PixelMap = map.Label;
    }
}
