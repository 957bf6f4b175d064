using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.Grids;

/// <summary>
/// What the ground is in each cell of a grid, at the cell's middle, and how high. Of surfaces above each other, as on a bridge, the one
/// nearest to the plane on which the vehicle stands counts, and of those less than 3 m from it the highest.
/// </summary>
public sealed class GroundMap
{
    /// <summary>
    /// Surfaces less far from each other belong to one level, metres: earth lies under roads, and bridges leave room for trucks.
    /// </summary>
    private const double SameLevel = 3;

    /// <summary>
    /// Lanes and crossings lie on a surface up to this distance, metres: their data may be less exact than the surface.
    /// </summary>
    private const double OnSurface = 0.5;

    /// <summary>Bodies reach down to this height above the ground in a cell, metres; others are on another level.</summary>
    private const double MaxGap = 3;

    /// <summary>Bodies reach up to this height at least, metres: they may be sunk by a little.</summary>
    private const double MaxSunk = -1;

    private readonly double[] _heights;
    private readonly GroundKind[] _kinds;

    /// <summary>Looks down on the ground.</summary>
    /// <param name="grid">The grid.</param>
    /// <param name="faces">The faces of the ground around it, in any order.</param>
    public GroundMap(EgoGrid grid, IReadOnlyList<GroundFace> faces)
    {
        Grid = Guard.NotNull(grid, nameof(grid));
        Guard.NotNull(faces, nameof(faces));
        int cells = grid.Cells * grid.Cells;
        _heights = new double[cells];
        _kinds = new GroundKind[cells];
        double[] nearest = new double[cells];
        for (int cell = 0; cell < cells; cell++)
        {
            _heights[cell] = double.NaN;
            nearest[cell] = double.NaN;
        }

        // Which level counts in each cell, then the highest surface on it, so that the order of the faces does not matter.
        VisitSurfaces(
            faces,
            (_, cell, height) =>
            {
                double level = LevelOf(cell);
                if (!(Math.Abs(height - level) >= Math.Abs(nearest[cell] - level)))
                {
                    nearest[cell] = height;
                }
            }
        );
        VisitSurfaces(
            faces,
            (kind, cell, height) =>
            {
                if (Math.Abs(height - nearest[cell]) <= SameLevel && IsAbove(kind, height, cell))
                {
                    (_heights[cell], _kinds[cell]) = (height, kind);
                }
            }
        );
        foreach (GroundFace face in faces.Where(static face => face.IsOnSurface))
        {
            GridFill.Visit(
                grid,
                face.A,
                face.B,
                face.C,
                (cell, height) =>
                {
                    if (_kinds[cell] != GroundKind.Other && Math.Abs(height - _heights[cell]) <= OnSurface && face.Kind > _kinds[cell])
                    {
                        _kinds[cell] = face.Kind;
                    }
                }
            );
        }
    }

    /// <summary>The grid.</summary>
    public EgoGrid Grid { get; }

    /// <summary>What the ground is, row by row.</summary>
    public IReadOnlyList<GroundKind> Kinds => _kinds;

    /// <summary>Height of the ground, row by row, metres, world; not a number where nothing is known.</summary>
    public IReadOnlyList<double> Heights => _heights;

    /// <summary>
    /// The normal of the ground in a cell, up, of unit length: its slope in each direction is that to the neighbour to which the height
    /// changes less, so that kerbs are no slopes.
    /// </summary>
    /// <param name="cell">The number of the cell, row by row.</param>
    public Vector3D NormalAt(int cell)
    {
        (int column, int row) = (cell % Grid.Cells, cell / Grid.Cells);
        double right = SlopeOf(cell, 1, column + 1 < Grid.Cells, column > 0);
        double ahead = -SlopeOf(cell, Grid.Cells, row + 1 < Grid.Cells, row > 0);
        return (new Vector3D(0, 0, 1) - (Grid.Right * right) - (Grid.Ahead * ahead)).Normalized();
    }

    /// <summary>The cells whose middles lie under or in a body on the ground, in ascending order.</summary>
    /// <param name="body">The body.</param>
    public IEnumerable<int> CellsUnder(Cuboid body)
    {
        Guard.NotNull(body, nameof(body));
        Vector2D[] corners = [.. Enumerable.Range(0, Cuboid.CornerCount).Select(number => Grid.PlaceOf(body.Corner(number)))];
        (int left, int right) = RangeOf(corners.Select(static corner => corner.X));
        (int top, int bottom) = RangeOf(corners.Select(static corner => corner.Y));
        double above = body.Centre.Z + body.HalfExtents.Length + 1;
        for (int row = top; row <= bottom; row++)
        {
            for (int column = left; column <= right; column++)
            {
                // The vertical line through the cell's middle, from above.
                Vector2D middle = Grid.CentreOf(column, row);
                var line = new Ray(new Vector3D(middle.X, middle.Y, above), new Vector3D(0, 0, -1));
                int cell = (row * Grid.Cells) + column;
                double ground = double.IsNaN(_heights[cell]) ? Grid.LevelAt(middle) : _heights[cell];
                if (body.Intersect(line) is { } span && above - span.Exit <= ground + MaxGap && above - span.Entry >= ground + MaxSunk)
                {
                    yield return cell;
                }
            }
        }
    }

    /// <summary>Rise of the ground towards the cells whose numbers are greater by a step, per metre.</summary>
    private double SlopeOf(int cell, int step, bool hasNext, bool hasBefore)
    {
        double next = hasNext ? _heights[cell + step] - _heights[cell] : double.NaN;
        double before = hasBefore ? _heights[cell] - _heights[cell - step] : double.NaN;
        double rise =
            double.IsNaN(next) ? before
            : double.IsNaN(before) || Math.Abs(next) < Math.Abs(before) ? next
            : before;
        return double.IsNaN(rise) ? 0 : rise / Grid.Shape.CellMetres;
    }

    private (int From, int To) RangeOf(IEnumerable<double> places)
    {
        double[] all = [.. places];
        return (
            (int)Math.Floor(Math.Max(0, Math.Min(Grid.Cells, all.Min()))),
            (int)Math.Ceiling(Math.Max(-1, Math.Min(Grid.Cells - 1, all.Max())))
        );
    }

    private void VisitSurfaces(IReadOnlyList<GroundFace> faces, Action<GroundKind, int, double> visit)
    {
        foreach (GroundFace face in faces.Where(static face => !face.IsOnSurface))
        {
            GridFill.Visit(Grid, face.A, face.B, face.C, (cell, height) => visit(face.Kind, cell, height));
        }
    }

    /// <summary>Whether a surface lies above what was found so far; of two at the same height, the drivable one does.</summary>
    private bool IsAbove(GroundKind kind, double height, int cell) =>
        double.IsNaN(_heights[cell]) || height > _heights[cell] || (height == _heights[cell] && kind > _kinds[cell]);

    private double LevelOf(int cell) => Grid.LevelAt(Grid.CentreOf(cell % Grid.Cells, cell / Grid.Cells));
}
