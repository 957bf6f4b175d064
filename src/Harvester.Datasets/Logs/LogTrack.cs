namespace Harvester.Datasets.Logs;

/// <summary>What one thing of a log does.</summary>
/// <param name="Id">Its number, which no other track of the log has.</param>
/// <param name="Kind">What it is.</param>
/// <param name="States">Its state at each step of the log; null where it is not known.</param>
internal sealed record LogTrack(int Id, TrafficLogKind Kind, IReadOnlyList<LogState?> States);
