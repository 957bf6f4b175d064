namespace Harvester.Geometry.Grids;

/// <summary>The size of a box of voxels, which are cubes, around a vehicle.</summary>
/// <param name="Cells">Number of voxels along its length and along its width.</param>
/// <param name="Layers">Number of voxels along its height.</param>
/// <param name="CellMetres">The side of a voxel, metres.</param>
/// <param name="LowestMetres">Height of its lower side above the origin of its frame, metres.</param>
public readonly record struct VoxelShape(int Cells, int Layers, double CellMetres, double LowestMetres)
{
    /// <summary>Maximum number of voxels along a side.</summary>
    public const int MaxCells = 1000;

    /// <summary>Maximum number of layers.</summary>
    public const int MaxLayers = 100;

    /// <summary>Minimum side of a voxel, metres.</summary>
    public const double MinCell = 0.05;

    /// <summary>Maximum side of a voxel, metres.</summary>
    public const double MaxCell = 5;

    /// <summary>Maximum distance of the lower side from the origin, metres.</summary>
    public const double MaxLowest = 100;

    /// <summary>Maximum number of voxels.</summary>
    public const int MaxCount = 20_000_000;

    /// <summary>That of Occ3D-nuScenes: 200 x 200 x 16 voxels of 0.4 m, from 1 m below to 5.4 m above the origin.</summary>
    public static VoxelShape Usual { get; } = new(200, 16, 0.4, -1);

    /// <summary>Number of voxels.</summary>
    public int Count => Cells * Cells * Layers;

    /// <summary>Distance of its farthest corners from the origin of its frame, metres.</summary>
    public double ReachMetres
    {
        get
        {
            double half = Cells * CellMetres / 2;
            double height = Math.Max(Math.Abs(LowestMetres), Math.Abs(LowestMetres + (Layers * CellMetres)));
            return Math.Sqrt((2 * half * half) + (height * height));
        }
    }

    /// <summary>Why there is no such box, one sentence; null if there is.</summary>
    public string? Problem =>
        Cells is < 1 or > MaxCells || Layers is < 1 or > MaxLayers || (long)Cells * Cells * Layers > MaxCount
            ? FormattableString.Invariant($"It has {Cells} x {Cells} x {Layers} voxels. There may be 1 to {MaxCells} along its sides, ")
                + FormattableString.Invariant($"1 to {MaxLayers} layers, and at most {MaxCount} in all.")
        : CellMetres is not (>= MinCell and <= MaxCell)
            ? FormattableString.Invariant($"The side of a voxel must be {MinCell} to {MaxCell} m, not {CellMetres} m.")
        : LowestMetres is not (>= -MaxLowest and <= MaxLowest)
            ? FormattableString.Invariant($"Its lower side must be at {-MaxLowest} to {MaxLowest} m, not {LowestMetres} m.")
        : null;
}
