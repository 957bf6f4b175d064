namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// What an adaptive pixel map may cost and how exact it shall be. The defaults are those of docs/pixel-maps.md's figures.
/// </summary>
public sealed record PixelMapOptions
{
    /// <summary>The greatest number of rays; at least 0. The map is finished without further rays when it is reached.</summary>
    public int RayBudget { get; init; } = int.MaxValue;

    /// <summary>Side of the cells that the map starts from, pixels; at least 2.</summary>
    public int CellSize { get; init; } = 32;

    /// <summary>
    /// The error that may remain in one cell, as a share of the visible pixels of the smallest object in it; greater than 0.
    /// </summary>
    public double CellErrorFraction { get; init; } = 0.0005;

    /// <summary>
    /// The greatest area of a cell across which an outline is taken to be straight, as a share of the visible pixels of the smallest object
    /// in it; greater than 0.
    /// </summary>
    public double StraightCellFraction { get; init; } = 0.027;

    /// <summary>
    /// How large a part of an object, as a share of its visible pixels, stands around each place that is asked whether more of it shows;
    /// greater than 0.
    /// </summary>
    public double UnsearchedFraction { get; init; } = 0.025;

    /// <summary>Beyond this distance rays are known not to meet entities, which are not looked for; metres, greater than 0.</summary>
    public double RayReachMetres { get; init; } = double.PositiveInfinity;

    internal PixelMapOptions Checked()
    {
        Guard.AtLeast(RayBudget, 0, nameof(RayBudget));
        Guard.AtLeast(CellSize, 2, nameof(CellSize));
        Guard.Positive(CellErrorFraction, nameof(CellErrorFraction));
        Guard.Positive(StraightCellFraction, nameof(StraightCellFraction));
        Guard.Positive(UnsearchedFraction, nameof(UnsearchedFraction));
        if (!double.IsPositiveInfinity(RayReachMetres))
        {
            Guard.Positive(RayReachMetres, nameof(RayReachMetres));
        }

        return this;
    }
}
