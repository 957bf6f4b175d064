using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A share of the scene's triangles, transformed, clipped and sorted into bands of rows. Chunks are made in parallel and drawn in order.
/// </summary>
internal sealed class TriangleChunk
{
    /// <summary>Triangles of meshes that one chunk takes.</summary>
    public const int Capacity = 2048;

    /// <summary>Bits that number a chunk's triangles on the screen: clipping makes at most two of one.</summary>
    public const int IndexBits = 12;

    private readonly List<MeshPiece> _pieces = [];
    private readonly List<ScreenTriangle> _triangles = [];
    private readonly List<List<int>> _bands = [];

    public int TriangleCount { get; private set; }

    public ReadOnlySpan<ScreenTriangle> Triangles => CollectionsMarshal.AsSpan(_triangles);

    public ReadOnlySpan<int> Band(int number) => CollectionsMarshal.AsSpan(_bands[number]);

    public void Clear(int bandCount)
    {
        _pieces.Clear();
        _triangles.Clear();
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

    /// <summary>Brings the chunk's pieces onto the screen.</summary>
    public void Process(View view, int bandHeight)
    {
        foreach (MeshPiece piece in _pieces)
        {
            var toClip = new ClipTransform(view.Matrix * Matrix4.ToWorld(piece.Instance.Pose));
            foreach (ref readonly MeshTriangle triangle in piece.Triangles)
            {
                Process(view, piece.Instance, triangle, toClip, bandHeight);
            }
        }
    }

    private void Process(View view, in MeshInstance instance, in MeshTriangle triangle, in ClipTransform toClip, int bandHeight)
    {
        Span<Vector256<double>> corners = stackalloc Vector256<double>[4];
        int count = NearClipper.Clip(toClip.Apply(triangle.A), toClip.Apply(triangle.B), toClip.Apply(triangle.C), view.NearClip, corners);
        Vector3? normal = null;
        for (int i = 2; i < count; i++)
        {
            Vector256<double> a = corners[0];
            Vector256<double> b = corners[i - 1];
            Vector256<double> c = corners[i];
            PixelRectangle pixels = view.PixelsIn(
                Vector256.MinNative(a, Vector256.MinNative(b, c)), Vector256.MaxNative(a, Vector256.MaxNative(b, c)));
            if (pixels.IsEmpty)
            {
                continue;
            }

            double doubleArea = ((b[0] - a[0]) * (c[1] - a[1])) - ((b[1] - a[1]) * (c[0] - a[0]));
            if (doubleArea != 0)
            {
                normal ??= NormalTowards(view.Camera.Pose.Position, instance.Pose, triangle);
                Add(new ScreenTriangle(
                    Vector4.Of(a), Vector4.Of(b), Vector4.Of(c), doubleArea, pixels, instance.Handle, triangle, normal.Value), bandHeight);
            }
        }
    }

    private void Add(in ScreenTriangle triangle, int bandHeight)
    {
        int last = (triangle.Pixels.Bottom - 1) / bandHeight;
        for (int band = triangle.Pixels.Top / bandHeight; band <= last; band++)
        {
            _bands[band].Add(_triangles.Count);
        }

        _triangles.Add(triangle);
    }

    private static Vector3 NormalTowards(Vector3D eye, Pose pose, in MeshTriangle triangle)
    {
        Vector3D across = pose.Axes.ToWorld((triangle.B - triangle.A).Cross(triangle.C - triangle.A));
        double sign = across.Dot(eye - pose.ToWorld(triangle.A)) < 0 ? -1 : 1;
        double length = across.Length;
        return length > 0 ? Sky.ToSingle(across * (sign / length)) : Vector3.UnitZ;
    }
}
