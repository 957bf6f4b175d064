using Harvester.Datasets.Logs;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>Something that moves, at a frame.</summary>
/// <param name="Key">What tells it from others of its place: the game's handle and the model, because the game reuses handles.</param>
/// <param name="Id">Its id in labels; null if it has none.</param>
/// <param name="Kind">What it is.</param>
/// <param name="State">Its box and velocity.</param>
internal sealed record MotionActor(string Key, int? Id, TrafficLogKind Kind, LogState State);
