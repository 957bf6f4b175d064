using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>A regulatory element of a Lanelet2 map.</summary>
/// <param name="Subtype">Its kind, as Lanelet2 calls it.</param>
/// <param name="Ways">Lines that it names, with their roles.</param>
/// <param name="Lanes">Lanelets that it names, with their roles.</param>
/// <param name="Governed">The lanes that it is a rule of.</param>
internal sealed record Lanelet2Rule(
    string Subtype,
    IReadOnlyList<(Lanelet2Way Way, string Role)> Ways,
    IReadOnlyList<(MapLane Lane, string Role)> Lanes,
    IReadOnlyList<MapLane> Governed
);
