namespace Harvester.Geometry.Grids;

/// <summary>
/// A box of voxels in a frame of its own (x right, y forward, z up, metres), whose origin is in the middle of its length and width. Voxels
/// are counted in columns from the left, rows from the front, and layers from below; the number of a voxel is
/// (layer · cells + row) · cells + column.
/// </summary>
public sealed class VoxelGrid
{
    private readonly double _half;

    /// <summary>Places a box.</summary>
    /// <param name="frame">Its frame in the world.</param>
    /// <param name="shape">Its size.</param>
    /// <exception cref="ArgumentException">There is no such box, or the frame has no orientation.</exception>
    public VoxelGrid(Pose frame, VoxelShape shape)
    {
        Guard.Finite(frame.Position, nameof(frame));
        Guard.Orientation(frame.Axes, nameof(frame));
        Shape = shape.Problem is { } problem ? throw new ArgumentException(problem, nameof(shape)) : shape;
        Frame = frame;
        _half = Shape.Cells / 2.0;
    }

    /// <summary>Its frame in the world.</summary>
    public Pose Frame { get; }

    /// <summary>Its size.</summary>
    public VoxelShape Shape { get; }

    /// <summary>
    /// Where a point is in the box: column, row and layer, continuous, so that a voxel's middle is at its numbers and a half; outside 0 to
    /// the numbers of voxels outside the box.
    /// </summary>
    /// <param name="world">The point, metres, world.</param>
    public Vector3D PlaceOf(Vector3D world)
    {
        Vector3D local = Frame.ToLocal(world);
        return new Vector3D(
            _half + (local.X / Shape.CellMetres),
            _half - (local.Y / Shape.CellMetres),
            (local.Z - Shape.LowestMetres) / Shape.CellMetres
        );
    }

    /// <summary>The point at a place in the box, metres, world: the inverse of <see cref="PlaceOf"/>.</summary>
    /// <param name="column">Column, continuous.</param>
    /// <param name="row">Row, continuous.</param>
    /// <param name="layer">Layer, continuous.</param>
    public Vector3D PointAt(double column, double row, double layer) =>
        Frame.ToWorld(
            new Vector3D(
                (column - _half) * Shape.CellMetres,
                (_half - row) * Shape.CellMetres,
                Shape.LowestMetres + (layer * Shape.CellMetres)
            )
        );

    /// <summary>The middle of a voxel, metres, world.</summary>
    /// <param name="voxel">Its number.</param>
    public Vector3D CentreOf(int voxel)
    {
        (int column, int row) = (voxel % Shape.Cells, voxel / Shape.Cells % Shape.Cells);
        return PointAt(column + 0.5, row + 0.5, (voxel / (Shape.Cells * Shape.Cells)) + 0.5);
    }

    /// <summary>The number of the voxel in which a place lies; -1 outside the box.</summary>
    /// <param name="place">Column, row and layer, continuous.</param>
    internal int VoxelAt(Vector3D place) =>
        place.X >= 0 && place.X < Shape.Cells && place.Y >= 0 && place.Y < Shape.Cells && place.Z >= 0 && place.Z < Shape.Layers
            ? ((((int)place.Z * Shape.Cells) + (int)place.Y) * Shape.Cells) + (int)place.X
            : -1;
}
