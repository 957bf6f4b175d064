using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Validation;

/// <summary>A label line with the results of those checks that must see the lines in their order.</summary>
/// <param name="Source">The line.</param>
internal sealed record CheckedLine(LabelLine Source)
{
    /// <summary>What contradicts earlier lines.</summary>
    public IReadOnlyList<string> Sequence { get; init; } = [];

    /// <summary>Names of files that an earlier line has.</summary>
    public IReadOnlyList<string> Taken { get; init; } = [];

    /// <summary>What the manifest says of the frame; null for nothing.</summary>
    public ManifestFrame? Manifest { get; init; }
}
