using Harvester.Datasets.Logs;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>A log that was read, and how many things of a kind were left out.</summary>
/// <param name="Log">The log.</param>
/// <param name="LeftOut">Numbers of things that a log cannot have, by what they are.</param>
internal sealed record LogReading(MotionLog Log, IReadOnlyDictionary<string, int> LeftOut);
