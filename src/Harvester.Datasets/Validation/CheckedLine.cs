using System.Collections.Generic;
using Harvester.Datasets.Sessions;

namespace Harvester.Datasets.Validation;

/// <summary>A line of labels with what was found out about it in the order of the lines.</summary>
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
