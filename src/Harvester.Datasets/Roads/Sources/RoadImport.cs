using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>A road network read from files.</summary>
/// <param name="Network">The road network.</param>
/// <param name="Format">Name of the format, for messages.</param>
/// <param name="Notes">What was skipped or corrected, one sentence each; empty if nothing was.</param>
public sealed record RoadImport(RoadNetwork Network, string Format, IReadOnlyList<string> Notes);
