using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;

namespace Harvester.Datasets.Exports;

/// <summary>What is exported, and how.</summary>
public sealed record ExportOptions
{
    /// <summary>Who goes to train, val and so on.</summary>
    public SplitPlan Splits { get; init; } = SplitPlan.Everything;

    /// <summary>Only objects of these classes; null for all.</summary>
    public IReadOnlyCollection<ObjectClass>? Classes { get; init; }

    /// <summary>Only objects of which at least this share is seen, 0 to 1. Where occlusion was not determined, the truncation alone counts.</summary>
    public double MinVisibleFraction { get; init; }

    /// <summary>Whether parts of other objects are exported.</summary>
    public PartSelection Parts { get; init; }

    /// <summary>How pixels are described in formats with the choice.</summary>
    public SegmentationKind Segmentation { get; init; }

    /// <summary>How images get into the dataset.</summary>
    public ImageTransfer Images { get; init; }

    /// <summary>The classes of the dataset, in the order of the enumeration.</summary>
    public IReadOnlyList<ObjectClass> ClassList => [.. Enum.GetValues<ObjectClass>().Where(Includes)];

    /// <summary>Whether an object is exported.</summary>
    public bool Includes(ObjectLabel label) =>
        Includes(label.Class) && Includes(label.Parent) && (label.VisibleFraction ?? (1 - label.TruncatedFraction)) >= MinVisibleFraction;

    /// <summary>The classes' names, in order, with commas.</summary>
    internal string ClassNames => string.Join(",", ClassList.Select(JsonName.Of));

    private bool Includes(int? parent) => Parts switch
    {
        PartSelection.None => parent is null,
        PartSelection.Only => parent is not null,
        _ => true,
    };

    private bool Includes(ObjectClass kind) => Classes?.Contains(kind) ?? true;
}
