using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Datasets.Boxes;

/// <summary>A camera and cuboids.</summary>
/// <param name="Camera">The camera.</param>
/// <param name="Cuboids">The cuboids with their names, if any.</param>
internal sealed record BoxScene(Camera Camera, IReadOnlyList<(string? Name, Cuboid Cuboid)> Cuboids);
