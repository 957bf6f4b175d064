using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>What the mask of a frame says of its objects. Its pixels get the objects' ids once all objects are labelled.</summary>
/// <param name="frame">The frame.</param>
/// <param name="made">Its mask, with the numbers of the targets.</param>
/// <param name="samples">Rays for an object whose mask leaves its occlusion open.</param>
/// <param name="rays">The ray caster.</param>
internal sealed class MaskedObjects(FrameDraft frame, MadeMap made, int samples, FrameRays rays)
{
    private readonly Box2D?[] _bounds = InstanceBounds.Of(made.Map);
    private readonly MapOcclusionEstimator _estimator = new(frame.Camera, made.Map, frame.Snapshot.Ego.Handle, rays, samples);
    private readonly ushort[] _ids = new ushort[frame.Targets.Count + 1];

    /// <summary>The occlusion of a candidate.</summary>
    /// <param name="candidate">Its place among the candidates.</param>
    /// <param name="mayCastRays">Whether rays may be cast for it.</param>
    public OcclusionEstimate OcclusionOf(int candidate, bool mayCastRays)
    {
        MapTarget target = frame.Targets[candidate];
        return mayCastRays && rays.Left >= samples
            ? _estimator.Estimate(target, made.Sights[target.Number])
            : new OcclusionEstimate { Sight = made.Sights[target.Number] };
    }

    /// <summary>The label of a candidate, completed by what the mask shows of it.</summary>
    /// <param name="candidate">Its place among the candidates.</param>
    /// <param name="label">Its label; null if it is not listed, so that the mask leaves it out.</param>
    public ObjectLabel? Completed(int candidate, ObjectLabel? label)
    {
        ushort number = frame.Targets[candidate].Number;
        _ids[number] = (ushort)(label?.Id ?? 0);
        return label is null ? null : label with { Box2DVisible = _bounds[number], AmodalMask = made.AmodalOf(number) };
    }

    /// <summary>Gives the frame its mask, with the ids of the objects that are listed.</summary>
    public void AddMask()
    {
        for (int i = 0; i < made.Map.Ids.Length; i++)
        {
            made.Map.Ids[i] = _ids[made.Map.Ids[i]];
        }

        frame.Mask = made.Map;
        frame.PixelMap = made.Label;
    }
}
