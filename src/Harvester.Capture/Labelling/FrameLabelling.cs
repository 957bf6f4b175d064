using System.Collections.Generic;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>What labelling makes of a snapshot.</summary>
/// <param name="Objects">The objects in the image, in the order of their ids.</param>
/// <param name="Mask">The instance map; null when none is wanted.</param>
internal sealed record FrameLabelling(IReadOnlyList<ObjectLabel> Objects, InstanceMap? Mask)
{
    /// <summary>How well the mask is known; null when none is wanted.</summary>
    public PixelMapLabel? PixelMap { get; init; }

    /// <summary>The numbers of the entities that have one, by handle.</summary>
    public IReadOnlyDictionary<int, int> Ids { get; init; } = new Dictionary<int, int>();

    /// <summary>What was found of the entities and faces in the image.</summary>
    public IReadOnlyList<RecordedOcclusion> Occlusions { get; init; } = [];

    /// <summary>The places of objects without a label, the nearest first.</summary>
    public IReadOnlyList<IgnoreRegion> IgnoreRegions { get; init; } = [];

    /// <summary>What was found of the entities beyond the labelling range that are in the image.</summary>
    public IReadOnlyList<DistantEntity> Distant { get; init; } = [];

    /// <summary>The rays that it took; null for labels made without a game.</summary>
    public RayCounts? Rays { get; init; }

    /// <summary>The lanes; null when no roads are known.</summary>
    public LanesLabel? Lanes { get; init; }
}
