using System.Collections.Generic;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>A road network as it was read from somebody's files.</summary>
/// <param name="Network">The roads.</param>
/// <param name="Format">The format of the files, in words.</param>
/// <param name="Notes">What was left out or put right, each a sentence; empty when nothing was.</param>
public sealed record RoadImport(RoadNetwork Network, string Format, IReadOnlyList<string> Notes);
