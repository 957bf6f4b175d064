namespace Harvester.Datasets.Roads.JsonDump;

/// <summary>A cell of the JSON dump.</summary>
internal sealed class DumpArea
{
    public required int AreaId { get; init; }

    public required IReadOnlyList<DumpNode> Nodes { get; init; }
}
