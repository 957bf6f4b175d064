using Harvester.Datasets.Files;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports;

/// <summary>Options of an export.</summary>
public sealed record ExportOptions
{
    /// <summary>Assignment of frames to splits.</summary>
    public SplitPlan Splits { get; init; } = SplitPlan.Everything;

    /// <summary>Classes of the objects to export; null for all.</summary>
    public IReadOnlyCollection<ObjectClass>? Classes { get; init; }

    /// <summary>Smallest visible fraction of the objects to export, 0 to 1. Above 0, objects of unknown occlusion are left out.</summary>
    public double MinVisibleFraction { get; init; }

    /// <summary>Whether parts of other objects are exported; null for the default of the format.</summary>
    public PartSelection? Parts { get; init; }

    /// <summary>The kind of boxes; null for those of visible pixels where there are masks, otherwise those of cuboids.</summary>
    public BoxKind? Boxes { get; init; }

    /// <summary>Names of classes in the dataset that do not have the default.</summary>
    public IReadOnlyDictionary<ObjectClass, string> Names { get; init; } = new Dictionary<ObjectClass, string>();

    /// <summary>Subclasses to split classes into.</summary>
    public Subclasses Subclasses { get; init; }

    /// <summary>Encoding of masks, in formats with a choice.</summary>
    public SegmentationKind Segmentation { get; init; }

    /// <summary>The lane lines of a frame, in formats with a choice.</summary>
    public LaneSelection Lanes { get; init; }

    /// <summary>The roads of sessions that do not keep theirs, in formats with a map; null for none.</summary>
    public RoadNetwork? Roads { get; init; }

    /// <summary>Name of the file of <see cref="Roads"/>.</summary>
    public string? RoadsName { get; init; }

    /// <summary>Whether images are linked or copied.</summary>
    public ImageTransfer Images { get; init; }

    /// <summary>Format of the images; null to keep that of each session.</summary>
    public ImageFormat? ImageFormat { get; init; }

    /// <summary>Quality of images that are converted to JPEG, 1 to 100; JPEG images are not converted again.</summary>
    public int JpegQuality { get; init; } = JpegEncoder.DefaultQuality;

    /// <summary>MUTCD codes of the signs in the sessions, in ordinal order; empty unless signs have subclasses.</summary>
    internal IReadOnlyList<string> MutcdCodes { get; init; } = [];

    /// <summary>Whether the sessions have class maps.</summary>
    internal bool HasClassMaps { get; init; }

    /// <summary>The exported classes, in the order of the enumeration.</summary>
    internal IReadOnlyList<ObjectClass> ClassList => [.. Enum.GetValues<ObjectClass>().Where(Includes)];

    /// <summary>Whether objects of a class are exported.</summary>
    internal bool Includes(ObjectClass kind) => Classes?.Contains(kind) ?? true;
}
