using System.Collections.Generic;
using Harvester.Capture.Labels;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Capture.Labelling;

/// <summary>What labelling makes of a snapshot.</summary>
/// <param name="Objects">The objects in the image, in the order of their ids.</param>
/// <param name="Mask">The instance map; null when none is wanted.</param>
internal sealed record FrameLabelling(IReadOnlyList<ObjectLabel> Objects, InstanceMap? Mask)
{
    /// <summary>How well the mask is known; null when none is wanted.</summary>
    public PixelMapLabel? PixelMap { get; init; }

    /// <summary>The lanes; null when no roads are known.</summary>
    public LanesLabel? Lanes { get; init; }
}
