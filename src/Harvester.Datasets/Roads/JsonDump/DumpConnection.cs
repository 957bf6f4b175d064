namespace Harvester.Datasets.Roads.JsonDump;

/// <summary>A directed link of the JSON dump.</summary>
internal sealed class DumpConnection
{
    public required DumpNode Node { get; init; }

    public required int LaneCountForward { get; init; }

    public required int LaneCountBackward { get; init; }
}
