using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>What a ray of a LiDAR met, or would meet.</summary>
/// <param name="Hit">What it met, and where.</param>
/// <param name="Normal">Unit normal of the surface, world; zero if unknown.</param>
/// <param name="IsInterpolated">Whether no ray of its own was cast.</param>
internal readonly record struct LidarReturn(RayHit Hit, Vector3D Normal, bool IsInterpolated);
