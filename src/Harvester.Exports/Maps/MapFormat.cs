using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>A file format for the lanes of a road network.</summary>
/// <param name="Name">Name on the command line.</param>
/// <param name="Ending">How names of its files end, with the dot. Several formats may share it.</param>
/// <param name="Description">What it is, in a few words.</param>
/// <param name="Write">
/// Writes a map that has at least one lane under a name to a stream. The same map gives the same bytes.
/// </param>
public sealed record MapFormat(string Name, string Ending, string Description, Action<LaneNetwork, string, Stream> Write);
