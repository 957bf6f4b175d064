namespace Harvester.Geometry.PixelMaps;

/// <summary>Cost and accuracy of an adaptive pixel map. The figures in docs/pixel-maps.md are measured with the defaults.</summary>
public sealed record PixelMapOptions
{
    /// <summary>Maximum number of rays; at least 0. When it is reached, the map is finished without further rays.</summary>
    public int RayBudget { get; init; } = int.MaxValue;

    /// <summary>Side of the initial cells, pixels; at least 2.</summary>
    public int CellSize { get; init; } = 32;

    /// <summary>
    /// Maximum error that may remain in one cell, as a fraction of the visible pixels of the smallest object in it; greater than 0.
    /// </summary>
    public double CellErrorFraction { get; init; } = 0.0005;

    /// <summary>
    /// Maximum area of a cell across which an outline is assumed to be straight, as a fraction of the visible pixels of the smallest object
    /// in it; greater than 0.
    /// </summary>
    public double StraightCellFraction { get; init; } = 0.027;

    /// <summary>
    /// Area around each point of the search for missing parts, as a fraction of the object's visible pixels; greater than 0.
    /// </summary>
    public double UnsearchedFraction { get; init; } = 0.025;

    /// <summary>Distance beyond which rays hit no entities, metres; greater than 0. Entities beyond it are not searched for.</summary>
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
