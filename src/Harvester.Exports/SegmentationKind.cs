namespace Harvester.Exports;

/// <summary>Encoding of an object's pixels, in formats with a choice.</summary>
public enum SegmentationKind
{
    /// <summary>Run lengths; exact.</summary>
    Rle,

    /// <summary>Polygons along pixel borders, a polygon for each region, which passes around its holes; exact.</summary>
    Polygon,
}
