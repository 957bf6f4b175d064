using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>Makes the labels of the objects of one snapshot: boxes by geometry, occlusion and masks by rays.</summary>
internal sealed class FrameLabeller(HarvestOptions options, IRayCaster rays, ObjectRegistry registry, IInstanceMapper mapper)
{
    private readonly OcclusionEstimator _occlusion = new(options.OcclusionSamples);

    /// <summary>The camera of the saved image.</summary>
    public static Camera CameraOf(HarvestOptions options, CameraState state) =>
        new(state.Pose, new CameraIntrinsics(state.VerticalFovDegrees, options.Image, state.WindowAspect, state.NearClip, options.Lens));

    /// <summary>
    /// Labels a snapshot a slice at a time. Each element is null until the work is done; the last is the result.
    /// The caller may leave off after any slice and go on in a later tick, as long as the game stands still.
    /// </summary>
    /// <param name="snapshot">The scene.</param>
    /// <param name="mayCastRays">Asked for each object; objects that get a no have no occlusion.</param>
    public IEnumerable<FrameLabelling?> Label(SceneSnapshot snapshot, Func<bool> mayCastRays)
    {
        Camera camera = CameraOf(options, snapshot.Camera);
        var objects = new List<ObjectLabel>();
        var numbers = new Dictionary<int, ushort>();
        foreach (EntityState entity in snapshot.Entities)
        {
            if (LabelOf(camera, snapshot.Ego.Handle, entity, mayCastRays) is { } label)
            {
                objects.Add(label);
                numbers[entity.Handle] = (ushort)label.Id;
            }

            yield return null;
        }

        objects.Sort(static (a, b) => a.Id.CompareTo(b.Id));
        if (!options.Masks)
        {
            yield return new FrameLabelling(objects, null);
            yield break;
        }

        var map = new InstanceMap(options.Image);
        Box2D[] boxes = [.. objects.Select(label => label.Box2D)];
        ushort NumberOf(int handle) => numbers.TryGetValue(handle, out ushort id) ? id : (ushort)0;
        foreach (bool _ in mapper.Fill(camera, boxes, NumberOf, snapshot.Ego.Handle, rays, map))
        {
            yield return null;
        }

        Box2D?[] bounds = InstanceBounds.Of(map);
        yield return new FrameLabelling(
            [.. objects.Select(label => label with { Box2DVisible = bounds[label.Id] })], map);
    }

    private ObjectLabel? LabelOf(Camera camera, int egoHandle, EntityState entity, Func<bool> mayCastRays)
    {
        if (options.Classes is { } classes && !classes.Contains(entity.Class))
        {
            return null;
        }

        Cuboid cuboid = Cuboid.FromModel(entity.ModelMin, entity.ModelMax, entity.Pose);
        CuboidProjection projection = CuboidProjector.Project(camera, cuboid);
        if (projection is not { Box: { } box, AmodalBox: { } amodal }
            || box.Area < options.MinBoxAreaPixels || box.Width < options.MinBoxSidePixels || box.Height < options.MinBoxSidePixels)
        {
            return null;
        }

        OcclusionEstimate occlusion = mayCastRays() ? _occlusion.Estimate(camera, cuboid, projection, entity.Handle, egoHandle, rays) : default;
        bool determined = occlusion.Method != OcclusionMethod.None;
        if (determined && occlusion.OccludedFraction > options.MaxOccludedFraction)
        {
            return null;
        }

        return new ObjectLabel
        {
            Id = registry.IdOf(entity),
            Class = entity.Class,
            Model = entity.Model,
            Box2D = box,
            Box2DAmodal = amodal,
            TruncatedFraction = projection.TruncatedFraction,
            OccludedFraction = determined ? occlusion.OccludedFraction : null,
            OcclusionMethod = occlusion.Method,
            Box3D = cuboid,
            DistanceMetres = (cuboid.Centre - camera.Pose.Position).Length,
            Velocity = entity.Velocity,
        };
    }
}
