using System.Collections.Generic;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Cli.Boxes;

/// <summary>A camera and the cuboids it looks at.</summary>
/// <param name="Camera">The camera.</param>
/// <param name="Cuboids">The cuboids with the names they were given, if any.</param>
internal sealed record BoxScene(Camera Camera, IReadOnlyList<(string? Name, Cuboid Cuboid)> Cuboids);
