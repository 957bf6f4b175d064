using System;
using System.Collections.Generic;
using System.Numerics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A share of the scene's triangles, transformed, clipped and sorted into bands of rows. Chunks are made in parallel and drawn in order.</summary>
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

    public ReadOnlySpan<ScreenTriangle> Triangles => System.Runtime.InteropServices.CollectionsMarshal.AsSpan(_triangles);

    public ReadOnlySpan<int> Band(int number) => System.Runtime.InteropServices.CollectionsMarshal.AsSpan(_bands[number]);

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
            Matrix4 toClip = view.Matrix * Matrix4.ToWorld(piece.Instance.Pose);
            foreach (ref readonly MeshTriangle triangle in piece.Triangles)
            {
                Process(view, piece.Instance, triangle, toClip, bandHeight);
            }
        }
    }

    private void Process(View view, in MeshInstance instance, in MeshTriangle triangle, in Matrix4 toClip, int bandHeight)
    {
        Span<Vector4> corners = stackalloc Vector4[4];
        int count = NearClipper.Clip(
            toClip.Transform(triangle.A), toClip.Transform(triangle.B), toClip.Transform(triangle.C), view.Camera.NearClip, corners);
        if (count == 0)
        {
            return;
        }

        Vector3? normal = null;
        for (int i = 2; i < count; i++)
        {
            Vector4 a = corners[0];
            Vector4 b = corners[i - 1];
            Vector4 c = corners[i];
            PixelRectangle pixels = view.PixelsIn(
                Math.Min(a.X, Math.Min(b.X, c.X)), Math.Min(a.Y, Math.Min(b.Y, c.Y)), Math.Max(a.X, Math.Max(b.X, c.X)), Math.Max(a.Y, Math.Max(b.Y, c.Y)));
            double area = ((b.X - a.X) * (c.Y - a.Y)) - ((b.Y - a.Y) * (c.X - a.X));
            if (pixels.IsEmpty || area == 0)
            {
                continue;
            }

            normal ??= NormalTowards(view.Camera.Pose.Position, instance.Pose, triangle);
            Add(new ScreenTriangle(a, b, c, pixels, instance.Handle, triangle, normal.Value), bandHeight);
        }
    }

    private void Add(in ScreenTriangle triangle, int bandHeight)
    {
        for (int band = triangle.Pixels.Top / bandHeight; band <= (triangle.Pixels.Bottom - 1) / bandHeight; band++)
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
