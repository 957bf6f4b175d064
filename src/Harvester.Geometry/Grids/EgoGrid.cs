namespace Harvester.Geometry.Grids;

/// <summary>
/// A square of cells on the ground, seen from above, with a vehicle's origin in its middle. It is level; the vehicle faces up the rows: row
/// 0 is the farthest ahead, column 0 the farthest to the left.
/// </summary>
public sealed class EgoGrid
{
    /// <summary>A vehicle whose up is this far from vertical, as cosine, does not stand on the ground beside it.</summary>
    private const double MinUpright = 0.8;

    private readonly Vector3D _origin;
    private readonly Vector3D _normal;
    private readonly Vector2D _right;
    private readonly Vector2D _ahead;
    private readonly double _half;

    /// <summary>Lays a grid around a vehicle.</summary>
    /// <param name="vehicle">Its pose in the world.</param>
    /// <param name="heightMetres">Height of its origin above the ground, metres.</param>
    /// <param name="shape">The size of the grid.</param>
    /// <exception cref="ArgumentException">There is no such grid, or the pose has no orientation.</exception>
    public EgoGrid(Pose vehicle, double heightMetres, GridShape shape)
    {
        Guard.Finite(heightMetres, nameof(heightMetres));
        Axes axes = Guard.Orientation(vehicle.Axes, nameof(vehicle));
        Shape = shape.Problem is { } problem ? throw new ArgumentException(problem, nameof(shape)) : shape;
        _half = Shape.Cells / 2.0;

        // The heading: forward without its height; of a vehicle that stands on its nose, the direction of its roof.
        var level = new Vector2D(axes.Forward.X, axes.Forward.Y);
        const double shortest = 1e-3;
        level = level.Length > shortest ? level : new Vector2D(axes.Up.X, axes.Up.Y);
        _ahead = level * (1 / level.Length);
        _right = new Vector2D(_ahead.Y, -_ahead.X);

        // The ground is taken to go on as the vehicle stands on it.
        _normal = axes.Up.Z >= MinUpright ? axes.Up : new Vector3D(0, 0, 1);
        _origin = vehicle.Position - new Vector3D(0, 0, heightMetres);
    }

    /// <summary>Its size.</summary>
    public GridShape Shape { get; }

    /// <summary>Number of cells along a side.</summary>
    public int Cells => Shape.Cells;

    /// <summary>The level direction to the right of the vehicle, a unit vector in the world.</summary>
    internal Vector3D Right => new(_right.X, _right.Y, 0);

    /// <summary>The level direction of its heading, a unit vector in the world.</summary>
    internal Vector3D Ahead => new(_ahead.X, _ahead.Y, 0);

    /// <summary>The middle of a cell on the ground, metres, world.</summary>
    public Vector2D CentreOf(int column, int row) =>
        new Vector2D(_origin.X, _origin.Y)
        + (_right * ((column + 0.5 - _half) * Shape.CellMetres))
        + (_ahead * ((_half - row - 0.5) * Shape.CellMetres));

    /// <summary>
    /// Where a point is on the grid: column and row, continuous, so that a cell's middle is at its numbers and a half; beyond 0 to the
    /// number of cells outside the grid.
    /// </summary>
    /// <param name="world">The point, metres; its height is ignored.</param>
    public Vector2D PlaceOf(Vector3D world)
    {
        var from = new Vector2D(world.X - _origin.X, world.Y - _origin.Y);
        return new Vector2D(_half + (from.Dot(_right) / Shape.CellMetres), _half - (from.Dot(_ahead) / Shape.CellMetres));
    }

    /// <summary>Height of the plane on which the vehicle stands, metres, world.</summary>
    /// <param name="world">A point above or below, metres.</param>
    public double LevelAt(Vector2D world) =>
        _origin.Z - (((_normal.X * (world.X - _origin.X)) + (_normal.Y * (world.Y - _origin.Y))) / _normal.Z);
}
