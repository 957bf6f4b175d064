using Harvester.Geometry;

namespace Harvester.Reports.Maps;

/// <summary>Lines of one kind on a map.</summary>
/// <param name="Name">The kind, for the legend.</param>
/// <param name="Colour">0xRRGGBB.</param>
/// <param name="WidthPixels">Width of the lines, pixels.</param>
/// <param name="Lines">The lines, metres, world.</param>
internal sealed record MapLayer(string Name, int Colour, double WidthPixels, IEnumerable<Vector3D[]> Lines);
