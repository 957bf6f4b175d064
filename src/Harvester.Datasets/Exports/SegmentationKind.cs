namespace Harvester.Datasets.Exports;

/// <summary>How an object's pixels are described where a format has the choice.</summary>
public enum SegmentationKind
{
    /// <summary>Run lengths: exact.</summary>
    Rle,

    /// <summary>Outlines along the borders of pixels: holes are filled.</summary>
    Polygon,
}
