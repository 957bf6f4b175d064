using Harvester.Sessions.Labels;

namespace Harvester.Exports.Pairs;

/// <summary>A picture of a moment.</summary>
/// <param name="Name">Name of its file, without a folder.</param>
/// <param name="Path">Path of the file within the session.</param>
/// <param name="Pair">What it shows.</param>
internal sealed record PairImage(string Name, string Path, PairLabel Pair);
