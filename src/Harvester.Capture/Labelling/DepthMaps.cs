using Harvester.Geometry.PixelMaps;

namespace Harvester.Capture.Labelling;

/// <summary>The depth maps of a frame, in the units of docs/depth.md.</summary>
/// <param name="Sparse">The depths that rays measured; 0 elsewhere.</param>
/// <param name="Completed">The depths of all pixels; null without a mask.</param>
/// <param name="Error">Their estimated errors; null without a mask.</param>
/// <param name="RaysCast">The rays cast for them alone.</param>
public sealed record DepthMaps(InstanceMap Sparse, InstanceMap? Completed, InstanceMap? Error, int RaysCast);
