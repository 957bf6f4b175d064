using System;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The rays of one frame, counted by their purpose and limited by a budget. Callers check the budget before they cast.
/// </summary>
/// <param name="rays">The ray caster.</param>
/// <param name="budget">Maximum number of rays per frame.</param>
internal sealed class FrameRays(IRayCaster rays, int budget) : IRayCaster
{
    private readonly int[] _counts = new int[1 + (int)RayPhase.Semantics];
    private RayPhase _phase;
    private int _cast;

    /// <summary>Number of rays left for the frame.</summary>
    public int Left => budget - _cast;

    /// <summary>The rays of the frame so far, by purpose.</summary>
    public RayCounts Counts => new(
        _counts[(int)RayPhase.Map],
        _counts[(int)RayPhase.Occlusion],
        _counts[(int)RayPhase.Faces],
        _counts[(int)RayPhase.IgnoreRegions],
        _counts[(int)RayPhase.Lanes],
        _counts[(int)RayPhase.Joints])
    {
        Classes = _counts[(int)RayPhase.Semantics],
    };

    /// <summary>Begins a frame.</summary>
    public void Begin()
    {
        Array.Clear(_counts, 0, _counts.Length);
        _cast = 0;
    }

    /// <summary>Sets the purpose of the following rays.</summary>
    public void Begin(RayPhase phase) => _phase = phase;

    /// <inheritdoc/>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        _counts[(int)_phase]++;
        _cast++;
        return rays.Cast(ray, maxDistance, ignoredEntity);
    }
}
