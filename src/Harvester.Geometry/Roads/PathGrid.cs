namespace Harvester.Geometry.Roads;

/// <summary>
/// The grids of the game's path files: square cells of nodes, and stored coordinates that are truncated toward zero to 1/4 m in x and y and
/// 1/32 m in z. A truncated coordinate is too close to zero by half a step on average; over the game's whole network the mean of true minus
/// stored was measured as 0.1245 m in x and y and 0.0153 m in z.
/// </summary>
public static class PathGrid
{
    /// <summary>Step of the stored x and y coordinates, metres.</summary>
    public const double HorizontalStep = 1.0 / 4;

    /// <summary>Step of the stored z coordinate, metres.</summary>
    public const double VerticalStep = 1.0 / 32;

    /// <summary>Length of a cell's side, metres.</summary>
    public const double CellSize = 512;

    /// <summary>Number of cells per side of the grid, west to east and south to north.</summary>
    public const int CellsPerSide = 32;

    private const double WesternAndSouthernEdge = -CellSize * CellsPerSide / 2;

    /// <summary>
    /// Removes the bias of truncation: moves each coordinate half a step away from zero. A coordinate stored as 0 is unchanged, because it
    /// stands for both sides of zero.
    /// </summary>
    /// <param name="stored">Metres, world, as path files and the game's functions give it.</param>
    public static Vector3D RemoveBias(Vector3D stored) =>
        new(
            stored.X + (Math.Sign(stored.X) * HorizontalStep / 2),
            stored.Y + (Math.Sign(stored.Y) * HorizontalStep / 2),
            stored.Z + (Math.Sign(stored.Z) * VerticalStep / 2)
        );

    /// <summary>Truncates a position as path files store it.</summary>
    /// <param name="position">Metres, world.</param>
    public static Vector3D Truncate(Vector3D position) =>
        new(
            Math.Truncate(position.X / HorizontalStep) * HorizontalStep,
            Math.Truncate(position.Y / HorizontalStep) * HorizontalStep,
            Math.Truncate(position.Z / VerticalStep) * VerticalStep
        );

    /// <summary>The number of the cell that contains a position; positions outside the grid count to its outermost cells.</summary>
    /// <param name="position">Metres, world.</param>
    /// <returns>0 in the south-west, increasing eastwards, then northwards: 0 to 1023.</returns>
    public static int CellOf(Vector3D position) => (Place(position.Y) * CellsPerSide) + Place(position.X);

    private static int Place(double coordinate) =>
        (int)Math.Max(0, Math.Min(CellsPerSide - 1, Math.Floor((coordinate - WesternAndSouthernEdge) / CellSize)));
}
