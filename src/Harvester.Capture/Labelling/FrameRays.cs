using System;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The rays of one frame, counted by their purpose and limited by a budget. Callers check the budget before they cast.
/// </summary>
/// <param name="rays">What rays meet.</param>
/// <param name="budget">Rays that a frame may take.</param>
internal sealed class FrameRays(IRayCaster rays, int budget) : IRayCaster
{
    private readonly int[] _counts = new int[1 + (int)RayPhase.Lanes];
    private RayPhase _phase;
    private int _cast;

    /// <summary>Rays that the frame may still take.</summary>
    public int Left => budget - _cast;

    /// <summary>The rays of the frame so far.</summary>
    public RayCounts Counts => new(
        _counts[(int)RayPhase.Map],
        _counts[(int)RayPhase.Occlusion],
        _counts[(int)RayPhase.Faces],
        _counts[(int)RayPhase.IgnoreRegions],
        _counts[(int)RayPhase.Lanes]);

    /// <summary>Begins a frame.</summary>
    public void Begin()
    {
        Array.Clear(_counts, 0, _counts.Length);
        _cast = 0;
    }

    /// <summary>Says what the rays from now on are for.</summary>
    public void Begin(RayPhase phase) => _phase = phase;

    /// <inheritdoc/>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        _counts[(int)_phase]++;
        _cast++;
        return rays.Cast(ray, maxDistance, ignoredEntity);
    }
}
