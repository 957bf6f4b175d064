namespace Harvester.Geometry.Grids;

/// <summary>The size of a square of square cells.</summary>
/// <param name="SideMetres">Its side, metres.</param>
/// <param name="CellMetres">The side of a cell, metres.</param>
public readonly record struct GridShape(double SideMetres, double CellMetres)
{
    /// <summary>Minimum side, metres.</summary>
    public const double MinSide = 10;

    /// <summary>Maximum side, metres.</summary>
    public const double MaxSide = 200;

    /// <summary>Minimum side of a cell, metres.</summary>
    public const double MinCell = 0.05;

    /// <summary>Maximum side of a cell, metres.</summary>
    public const double MaxCell = 2;

    /// <summary>Maximum number of cells along a side.</summary>
    public const int MaxCells = 2000;

    /// <summary>A side is a whole number of cells up to this part of a cell.</summary>
    private const double WholeTolerance = 1e-6;

    /// <summary>The usual size: 80 m with cells of 0.2 m.</summary>
    public static GridShape Usual { get; } = new(80, 0.2);

    /// <summary>Number of cells along a side.</summary>
    public int Cells => (int)Math.Round(SideMetres / CellMetres);

    /// <summary>Distance of its corners from its middle, metres.</summary>
    public double ReachMetres => SideMetres / Math.Sqrt(2);

    /// <summary>Why there is no such square, one sentence; null if there is.</summary>
    public string? Problem
    {
        get
        {
            double cells = SideMetres / CellMetres;
            return SideMetres is not (>= MinSide and <= MaxSide) ? Invalid("side", SideMetres, MinSide, MaxSide)
                : CellMetres is not (>= MinCell and <= MaxCell) ? Invalid("cells", CellMetres, MinCell, MaxCell)
                : Cells > MaxCells || Math.Abs(cells - Cells) > WholeTolerance
                    ? FormattableString.Invariant($"A side of {SideMetres} m has {cells:0.###} cells of {CellMetres} m, ")
                        + FormattableString.Invariant($"but it must have a whole number of them, at most {MaxCells}.")
                : null;
        }
    }

    private static string Invalid(string what, double value, double min, double max) =>
        FormattableString.Invariant($"The {what} of a grid must be {min} to {max} m, not {value} m.");
}
