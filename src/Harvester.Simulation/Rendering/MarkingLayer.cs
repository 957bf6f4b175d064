using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Which fraction of each pixel road markings cover, and in which colour. Depths and handles are those of the road below.
/// </summary>
internal sealed class MarkingLayer
{
    /// <summary>
    /// A marking lies a few millimetres above the asphalt. What is nearer than it by more than this fraction of its distance stands before
    /// it: so coarse that single precision and bumps between road pieces do not matter, and less than a kerb seen from a car.
    /// </summary>
    private const double DepthRoom = 1e-3;

    /// <summary>Markings farther away than this are too thin to show, metres.</summary>
    private const double MaxDepth = 250;

    private readonly List<MeshInstance> _instances = [];
    private MarkingTriangle[][] _triangles = [];
    private float[] _coverage = [];
    private Rgb[] _colours = [];
    private bool[] _hasAny = [];
    private int _width;

    /// <summary>Starts a new picture.</summary>
    public void Clear(int width, int height)
    {
        _instances.Clear();
        _width = width;
        if (_coverage.Length != width * height || _hasAny.Length != height)
        {
            _coverage = new float[width * height];
            _colours = new Rgb[width * height];
            _hasAny = new bool[height];
        }

        for (int row = 0; row < height; row++)
        {
            if (_hasAny[row])
            {
                _coverage.AsSpan(row * width, width).Clear();
                _hasAny[row] = false;
            }
        }
    }

    /// <summary>Adds an instance whose triangles are markings.</summary>
    public void Add(in MeshInstance instance) => _instances.Add(instance);

    /// <summary>Brings onto the screen what is not hidden behind the rest of the picture.</summary>
    public void Project(View view, DepthTiles tiles)
    {
        _triangles = new MarkingTriangle[_instances.Count][];
        Parallel.For(0, _instances.Count, number => _triangles[number] = TrianglesOf(_instances[number], view, tiles));
    }

    /// <summary>Covers the pixels of a band of rows.</summary>
    /// <param name="view">The view.</param>
    /// <param name="top">First row.</param>
    /// <param name="bottom">Row after the last one.</param>
    /// <param name="nearness">Near / depth of all pixels of the image.</param>
    public void Draw(View view, int top, int bottom, ReadOnlySpan<float> nearness)
    {
        foreach (MarkingTriangle[] triangles in _triangles)
        {
            foreach (ref readonly MarkingTriangle triangle in triangles.AsSpan())
            {
                int last = Math.Min(bottom, triangle.Pixels.Bottom);
                for (int row = Math.Max(top, triangle.Pixels.Top); row < last; row++)
                {
                    DrawRow(triangle, view, row, nearness);
                }
            }
        }
    }

    /// <summary>Enters markings into what a row of the road shows, where they cover at least half of a pixel.</summary>
    public void AddTo(Span<SurfaceKind> kinds, int row)
    {
        const float half = 0.5f;
        for (int column = 0; _hasAny[row] && column < kinds.Length; column++)
        {
            if (kinds[column] == SurfaceKind.Road && _coverage[(row * _width) + column] >= half)
            {
                kinds[column] = SurfaceKind.Marking;
            }
        }
    }

    /// <summary>Whether a row shows any marking.</summary>
    public bool HasAny(int row) => _hasAny[row];

    /// <summary>The covered fraction of each pixel of a row.</summary>
    public ReadOnlySpan<float> CoverageOf(int row) => _coverage.AsSpan(row * _width, _width);

    /// <summary>The colours of the markings of a row, where it is covered.</summary>
    public ReadOnlySpan<Rgb> ColoursOf(int row) => _colours.AsSpan(row * _width, _width);

    private void DrawRow(in MarkingTriangle triangle, View view, int row, ReadOnlySpan<float> nearness)
    {
        (int first, int end) = view.Grid is null
            ? triangle.ColumnsNear(row + 0.5, triangle.Pixels.Left, triangle.Pixels.Right)
            : (triangle.Pixels.Left, triangle.Pixels.Right);
        for (int column = first; column < end; column++)
        {
            Geometry.Vector2D place = view.SampleAt(column, row);
            double covered = triangle.CoverageAt(place.X, place.Y);
            int pixel = (row * _width) + column;
            if (covered > 0 && triangle.NearnessAt(place.X, place.Y) * (1 + DepthRoom) > nearness[pixel])
            {
                _coverage[pixel] = Math.Min(1, _coverage[pixel] + (float)covered);
                _colours[pixel] = triangle.Colour;
                _hasAny[row] = true;
            }
        }
    }

    private static MarkingTriangle[] TrianglesOf(in MeshInstance instance, View view, DepthTiles tiles)
    {
        var toClip = new ClipTransform(view.Matrix * Matrix4.ToWorld(instance.Pose));
        if (ScreenBox.Of(instance.Mesh.Bounds, toClip, view) is { } box && box.Nearness * MaxDepth < view.NearClip)
        {
            return [];
        }

        var triangles = new List<MarkingTriangle>();
        Span<Vector256<double>> corners = stackalloc Vector256<double>[4];
        foreach (ref readonly MeshTriangle triangle in instance.Mesh.Given)
        {
            int count = NearClipper.Clip(
                toClip.Apply(triangle.A),
                toClip.Apply(triangle.B),
                toClip.Apply(triangle.C),
                view.NearClip,
                corners
            );
            for (int i = 2; i < count; i++)
            {
                (Vector256<double> a, Vector256<double> b, Vector256<double> c) = (corners[0], corners[i - 1], corners[i]);
                Vector256<double> min = Vector256.MinNative(a, Vector256.MinNative(b, c));
                Vector256<double> max = Vector256.MaxNative(a, Vector256.MaxNative(b, c));
                (min, max) = (min - Vector256<double>.One, max + Vector256<double>.One);
                PixelRectangle pixels = view.PixelsIn(min[0], min[1], max[0], max[1]);
                double doubleArea = ((b[0] - a[0]) * (c[1] - a[1])) - ((b[1] - a[1]) * (c[0] - a[0]));
                if (pixels.IsEmpty || doubleArea == 0)
                {
                    continue;
                }

                var projected = new MarkingTriangle(a, b, c, doubleArea, pixels, triangle.Colour);
                if (!tiles.Hide(pixels, projected.MaxNearness(min, max) * (1 + DepthRoom)))
                {
                    triangles.Add(projected);
                }
            }
        }

        return [.. triangles];
    }
}
