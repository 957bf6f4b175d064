using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Depth;

/// <summary>The places at which depths are wanted: the pixels of an image, or the columns and beams of a LiDAR.</summary>
/// <param name="Size">Columns and rows; at least 2 x 2.</param>
/// <param name="LineOf">The line of sight of a place: column, row.</param>
public sealed record DepthGrid(ImageSize Size, Func<int, int, SightLine> LineOf)
{
    /// <summary>Width of the first cells, columns.</summary>
    public int FirstWidth { get; init; } = 16;

    /// <summary>Height of the first cells, rows.</summary>
    public int FirstHeight { get; init; } = 16;

    /// <summary>Whether the middle of the first cells is sampled too.</summary>
    public bool SamplesMiddles { get; init; } = true;

    /// <summary>Cells no longer than this are not divided.</summary>
    public int LastSide { get; init; } = 2;

    /// <summary>
    /// Error of a depth that does not matter, metres, if all greater ones matter alike; null if errors matter by their fraction of the
    /// depth.
    /// </summary>
    public double? ToleranceMetres { get; init; }

    /// <summary>The mask's number at each place, row by row; null without a mask.</summary>
    public ushort[]? Regions { get; init; }

    /// <summary>The number of a place.</summary>
    public int At(int column, int row) => (row * Size.Width) + column;

    /// <summary>The mask's number at a place.</summary>
    public ushort RegionAt(int at) => Regions?[at] ?? 0;

    /// <summary>The line of sight of a place by its number.</summary>
    public SightLine LineAt(int at) => LineOf(at % Size.Width, at / Size.Width);
}
