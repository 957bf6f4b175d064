namespace Harvester.Geometry.Maps;

/// <summary>What a road meets at one of its ends: a junction, another road, or nothing.</summary>
/// <param name="Junction">Index of the junction; null if there is none.</param>
/// <param name="Link">Index of the link that continues the road; null if none does.</param>
/// <param name="AtStartOfLink">Whether the road meets that link at its start.</param>
public readonly record struct SegmentEnd(int? Junction, int? Link, bool AtStartOfLink);
