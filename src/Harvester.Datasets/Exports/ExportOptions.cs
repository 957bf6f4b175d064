using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Exports;

/// <summary>What is exported, and how.</summary>
public sealed record ExportOptions
{
    /// <summary>Who goes to train, val and so on.</summary>
    public SplitPlan Splits { get; init; } = SplitPlan.Everything;

    /// <summary>Only objects of these classes; null for all.</summary>
    public IReadOnlyCollection<ObjectClass>? Classes { get; init; }

    /// <summary>
    /// Only objects of which at least this share is seen, 0 to 1. Above 0, an object whose occlusion was not determined is left out.
    /// </summary>
    public double MinVisibleFraction { get; init; }

    /// <summary>Whether parts of other objects are exported; null for what is usual in the format.</summary>
    public PartSelection? Parts { get; init; }

    /// <summary>Which boxes are exported; null for those of the visible pixels where there are masks, else those of cuboids.</summary>
    public BoxKind? Boxes { get; init; }

    /// <summary>Names of classes in the dataset, where they are not the project's or the format's own.</summary>
    public IReadOnlyDictionary<ObjectClass, string> Names { get; init; } = new Dictionary<ObjectClass, string>();

    /// <summary>What classes are divided by.</summary>
    public Subclasses Subclasses { get; init; }

    /// <summary>How pixels are described in formats with the choice.</summary>
    public SegmentationKind Segmentation { get; init; }

    /// <summary>How images get into the dataset.</summary>
    public ImageTransfer Images { get; init; }

    /// <summary>The format of the images; null to keep that of each session.</summary>
    public ImageFormat? ImageFormat { get; init; }

    /// <summary>Quality of images that become JPEG, 1 to 100; those that are JPEG already stay as they are.</summary>
    public int JpegQuality { get; init; } = JpegEncoder.DefaultQuality;

    /// <summary>MUTCD codes of the signs in the sessions, in ordinal order; empty unless signs are divided by them.</summary>
    internal IReadOnlyList<string> MutcdCodes { get; init; } = [];

    /// <summary>The classes that are exported, in the order of the enumeration.</summary>
    internal IReadOnlyList<ObjectClass> ClassList => [.. Enum.GetValues<ObjectClass>().Where(Includes)];

    /// <summary>Whether objects of a class are exported.</summary>
    internal bool Includes(ObjectClass kind) => Classes?.Contains(kind) ?? true;
}
