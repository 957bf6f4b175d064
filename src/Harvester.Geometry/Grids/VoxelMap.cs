namespace Harvester.Geometry.Grids;

/// <summary>
/// What is in each voxel of a box: surfaces, which it is built from triangle by triangle, free space, or what surfaces enclose. A voxel is
/// occupied if some of a surface lies in it.
/// </summary>
public sealed class VoxelMap
{
    /// <summary>The kind of a voxel that is free.</summary>
    public const byte Free = 0;

    /// <summary>
    /// The kind of a voxel without a surface to which no way of free voxels leads from above or from the vehicle: the inside of bodies, and
    /// what is below the ground.
    /// </summary>
    public const byte Enclosed = 255;

    private readonly byte[] _kinds;
    private readonly int[] _owners;
    private readonly bool[] _covered;
    private readonly IReadOnlyList<byte> _ranks;
    private readonly TriangleVoxels _triangles;
    private readonly int _cells;
    private readonly int _layers;

    /// <summary>Starts with free voxels.</summary>
    /// <param name="grid">The box.</param>
    /// <param name="ranks">The rank of each kind of surface, all different: of several in a voxel, the greatest rank counts.</param>
    public VoxelMap(VoxelGrid grid, IReadOnlyList<byte> ranks)
    {
        Grid = Guard.NotNull(grid, nameof(grid));
        _ranks = Guard.NotNull(ranks, nameof(ranks));
        (_cells, _layers) = (grid.Shape.Cells, grid.Shape.Layers);
        _kinds = new byte[grid.Shape.Count];
        _owners = new int[grid.Shape.Count];
        _covered = new bool[_cells * _cells];
        _triangles = new TriangleVoxels(_cells);
    }

    /// <summary>The box.</summary>
    public VoxelGrid Grid { get; }

    /// <summary>What each voxel is: <see cref="Free"/>, <see cref="Enclosed"/>, or a kind of surface.</summary>
    public IReadOnlyList<byte> Kinds => _kinds;

    /// <summary>The number of the body whose surface each voxel has; 0 for none.</summary>
    public IReadOnlyList<int> Owners => _owners;

    /// <summary>Adds a surface.</summary>
    /// <param name="kind">Its kind, 1 to 254.</param>
    /// <param name="owner">The number of its body, 0 for none; of bodies of one kind in a voxel, the smallest counts.</param>
    /// <param name="a">First corner, as a place in the box: <see cref="VoxelGrid.PlaceOf"/>.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    public void Add(byte kind, int owner, Vector3D a, Vector3D b, Vector3D c)
    {
        if (Math.Max(a.Z, Math.Max(b.Z, c.Z)) < 0)
        {
            return;
        }

        _triangles.Begin(a, b, c);
        while (_triangles.Next())
        {
            (int first, int last) = _triangles.Layers;
            if (last >= _layers)
            {
                _covered[_triangles.Cell] = true;
                last = _layers - 1;
            }

            for (int layer = Math.Max(0, first); layer <= last; layer++)
            {
                Mark((layer * _cells * _cells) + _triangles.Cell, kind, owner);
            }
        }
    }

    /// <summary>
    /// Finds what surfaces enclose, when all have been added: free voxels are those that are connected, side by side, with the open sky or
    /// with the space above the origin of the box.
    /// </summary>
    public void Close()
    {
        var reached = new bool[_kinds.Length];
        var waiting = new Stack<int>();
        int layerSize = _cells * _cells;
        int top = (_layers - 1) * layerSize;
        for (int cell = 0; cell < layerSize; cell++)
        {
            if (!_covered[cell])
            {
                Reach(top + cell);
            }
        }

        // The vehicle itself is not among the surfaces, so the lowest free voxel above the ground at the origin is where it is.
        int middle = ((_cells / 2) * _cells) + (_cells / 2);
        bool isAboveGround = false;
        for (int layer = 0; layer < _layers; layer++)
        {
            bool isFree = _kinds[(layer * layerSize) + middle] == Free;
            if (isFree && isAboveGround)
            {
                Reach((layer * layerSize) + middle);
                break;
            }

            isAboveGround |= !isFree;
        }

        while (waiting.Count > 0)
        {
            int voxel = waiting.Pop();
            (int column, int row, int layer) = (voxel % _cells, voxel / _cells % _cells, voxel / layerSize);
            if (column > 0)
            {
                Reach(voxel - 1);
            }

            if (column < _cells - 1)
            {
                Reach(voxel + 1);
            }

            if (row > 0)
            {
                Reach(voxel - _cells);
            }

            if (row < _cells - 1)
            {
                Reach(voxel + _cells);
            }

            if (layer > 0)
            {
                Reach(voxel - layerSize);
            }

            if (layer < _layers - 1)
            {
                Reach(voxel + layerSize);
            }
        }

        for (int voxel = 0; voxel < _kinds.Length; voxel++)
        {
            if (_kinds[voxel] == Free && !reached[voxel])
            {
                _kinds[voxel] = Enclosed;
            }
        }

        void Reach(int voxel)
        {
            if (_kinds[voxel] == Free && !reached[voxel])
            {
                reached[voxel] = true;
                waiting.Push(voxel);
            }
        }
    }

    /// <summary>What a voxel is.</summary>
    internal byte KindAt(int voxel) => _kinds[voxel];

    private void Mark(int voxel, byte kind, int owner)
    {
        byte present = _kinds[voxel];
        if (present == Free || _ranks[kind] > _ranks[present])
        {
            (_kinds[voxel], _owners[voxel]) = (kind, owner);
        }
        else if (present == kind && owner < _owners[voxel])
        {
            _owners[voxel] = owner;
        }
    }
}
