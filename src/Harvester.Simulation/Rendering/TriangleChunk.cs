using System.Numerics;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A part of the scene's triangles, transformed, clipped and sorted into bands of rows. Chunks are made in parallel and drawn in order.
/// </summary>
internal sealed class TriangleChunk
{
    /// <summary>Maximum number of mesh triangles in a chunk.</summary>
    public const int Capacity = 2048;

    /// <summary>Bits for the index of a triangle within a chunk: clipping makes at most two of one.</summary>
    public const int IndexBits = 12;

    /// <summary>Nodes of fewer triangles are not worth a test of their own.</summary>
    private const int MinNodeTested = 8;

    private const int NearnessElement = 2;

    private readonly List<MeshPiece> _pieces = [];
    private ScreenTriangle[] _triangles = new ScreenTriangle[64];
    private int _shown;
    private readonly List<List<int>> _bands = [];

    public int TriangleCount { get; private set; }

    /// <summary>Those on the screen.</summary>
    public ReadOnlySpan<ScreenTriangle> Triangles => _triangles.AsSpan(0, _shown);

    public ref readonly ScreenTriangle this[int index] => ref _triangles[index];

    public ReadOnlySpan<int> Band(int number) => CollectionsMarshal.AsSpan(_bands[number]);

    public void Clear(int bandCount)
    {
        _pieces.Clear();
        _shown = 0;
        TriangleCount = 0;
        while (_bands.Count < bandCount)
        {
            _bands.Add([]);
        }

        foreach (List<int> band in _bands)
        {
            band.Clear();
        }
    }

    public void Add(MeshPiece piece)
    {
        _pieces.Add(piece);
        TriangleCount += piece.Count;
    }

    /// <summary>Brings what may be seen of the chunk's pieces onto the screen.</summary>
    public void Process(View view, DepthTiles tiles, int bandHeight)
    {
        foreach (MeshPiece piece in _pieces)
        {
            Process(view, tiles, piece, bandHeight);
        }
    }

    private void Process(View view, DepthTiles tiles, in MeshPiece piece, int bandHeight)
    {
        Matrix4 matrix = view.Matrix * Matrix4.ToWorld(piece.Instance.Pose);
        var toClip = new ClipTransform(matrix);
        Span<Plane> sides = stackalloc Plane[View.SideCount];
        view.WriteSides(matrix, sides);
        ReadOnlySpan<HierarchyNode> nodes = piece.Instance.Mesh.Tree.Hierarchy.Nodes;
        Span<int> stack = stackalloc int[BoundingVolumeHierarchy.MaxTreeDepth];
        int end = piece.First + piece.Count;
        int depth = 1;
        stack[0] = 0;
        while (depth > 0)
        {
            ref readonly HierarchyNode node = ref nodes[stack[--depth]];
            int first = Math.Max(node.First, piece.First);
            int count = Math.Min(node.First + node.Count, end) - first;
            if (count <= 0 || (node.Count >= MinNodeTested && CannotBeSeen(node.Bounds, toClip, sides, view, tiles)))
            {
                continue;
            }

            if (node.IsLeaf || node.Count < MinNodeTested)
            {
                foreach (ref readonly MeshTriangle triangle in piece.Instance.Mesh.Triangles.Slice(first, count))
                {
                    Process(view, tiles, piece.Instance, triangle, toClip, bandHeight);
                }
            }
            else
            {
                stack[depth++] = node.Child + 1;
                stack[depth++] = node.Child;
            }
        }
    }

    /// <summary>Whether a box is out of view, between the centres of pixels, or behind what is drawn.</summary>
    private static bool CannotBeSeen(in Bounds box, in ClipTransform toClip, ReadOnlySpan<Plane> sides, View view, DepthTiles tiles)
    {
        foreach (ref readonly Plane side in sides)
        {
            if (side.IsOutside(box))
            {
                return true;
            }
        }

        return ScreenBox.Of(box, toClip, view) is { } onScreen
            && (onScreen.Pixels.IsEmpty || tiles.Hide(onScreen.Pixels, onScreen.Nearness));
    }

    private void Process(
        View view,
        DepthTiles tiles,
        in MeshInstance instance,
        in MeshTriangle triangle,
        in ClipTransform toClip,
        int bandHeight
    )
    {
        Span<Vector256<double>> corners = stackalloc Vector256<double>[4];
        int count = NearClipper.Clip(toClip.Apply(triangle.A), toClip.Apply(triangle.B), toClip.Apply(triangle.C), view.NearClip, corners);
        Vector3? normal = null;
        LanePlane lanes = default;
        for (int i = 2; i < count; i++)
        {
            Vector256<double> a = corners[0];
            Vector256<double> b = corners[i - 1];
            Vector256<double> c = corners[i];
            Vector256<double> max = Vector256.MaxNative(a, Vector256.MaxNative(b, c));
            PixelRectangle pixels = view.PixelsIn(Vector256.MinNative(a, Vector256.MinNative(b, c)), max);
            if (pixels.IsEmpty || tiles.Hide(pixels, max[NearnessElement]))
            {
                continue;
            }

            double doubleArea = ((b[0] - a[0]) * (c[1] - a[1])) - ((b[1] - a[1]) * (c[0] - a[0]));
            if (doubleArea != 0)
            {
                if (normal is null)
                {
                    normal = NormalTowards(view.Camera.Pose.Position, instance.Pose, triangle);
                    lanes = triangle.Lanes.Outer > 0 ? new LanePlane(triangle, instance.Pose, view.Camera.Pose.Position) : default;
                }

                var shown = new ScreenTriangle(
                    a,
                    b,
                    c,
                    doubleArea,
                    pixels,
                    instance.Handle,
                    instance.Mesh.Kind,
                    triangle,
                    normal.Value,
                    lanes
                );
                Add(shown, bandHeight);
            }
        }
    }

    private void Add(in ScreenTriangle triangle, int bandHeight)
    {
        int last = (triangle.Pixels.Bottom - 1) / bandHeight;
        for (int band = triangle.Pixels.Top / bandHeight; band <= last; band++)
        {
            _bands[band].Add(_shown);
        }

        if (_shown == _triangles.Length)
        {
            Array.Resize(ref _triangles, 2 * _shown);
        }

        _triangles[_shown++] = triangle;
    }

    private static Vector3 NormalTowards(Vector3D eye, Pose pose, in MeshTriangle triangle)
    {
        // The normal is the cross product of two sides, turned towards the eye.
        Vector3D across = pose.Axes.ToWorld((triangle.B - triangle.A).Cross(triangle.C - triangle.A));
        double sign = across.Dot(eye - pose.ToWorld(triangle.A)) < 0 ? -1 : 1;
        double length = across.Length;
        return length > 0 ? Sky.ToSingle(across * (sign / length)) : Vector3.UnitZ;
    }
}
