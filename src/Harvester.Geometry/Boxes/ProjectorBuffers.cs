namespace Harvester.Geometry.Boxes;

/// <summary>Intermediate results of projecting a cuboid; one instance per thread, which is reused.</summary>
internal sealed class ProjectorBuffers
{
    [ThreadStatic]
    private static ProjectorBuffers? _ofThread;

    private Vector3D[] _ends = new Vector3D[2 * Cuboid.EdgeCount];

    /// <summary>The instance of the calling thread.</summary>
    public static ProjectorBuffers OfThread => _ofThread ??= new ProjectorBuffers();

    /// <summary>The corners of the cuboid in the camera's frame.</summary>
    public Vector3D[] Corners { get; } = new Vector3D[Cuboid.CornerCount];

    /// <summary>Points of the body before the hull is taken; unused afterwards.</summary>
    public PointBuffer Points { get; } = new();

    /// <summary>The hull before distortion by the lens; unused afterwards.</summary>
    public PointBuffer Hull { get; } = new();

    /// <summary>The outline in the image.</summary>
    public PointBuffer Outline { get; } = new();

    /// <summary>The part of the outline within the image.</summary>
    public PointBuffer InImage { get; } = new();

    /// <summary>Number of end points.</summary>
    public int EndCount { get; private set; }

    /// <summary>An end of an edge in front of the near plane, in the camera's frame.</summary>
    public Vector3D End(int index) => _ends[index];

    public void ClearEnds() => EndCount = 0;

    public void AddEnd(Vector3D end)
    {
        if (EndCount == _ends.Length)
        {
            Array.Resize(ref _ends, 2 * EndCount);
        }

        _ends[EndCount++] = end;
    }
}
