using System;
using System.Collections.Generic;
using System.Threading.Tasks;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Draws a scene on the processor: meshes through 4x4 matrices into a z-buffer, bands of rows in parallel, then light and air for each
/// pixel. Pixel (i, j) shows what lies at its centre (i + 0.5, j + 0.5); both sides of a triangle are drawn. The same scene and
/// camera give the same bytes. A renderer keeps its buffers from frame to frame and serves one caller at a time.
/// </summary>
public sealed class Renderer
{
    private const int BandHeight = 16;
    private readonly List<TriangleChunk> _chunks = [];
    private readonly List<(int First, int Count)> _instances = [];
    private readonly List<(int First, int Count)> _triangles = [];
    private int _chunkCount;
    private readonly ScreenTriangles _screen;
    private byte[] _stepped = [];
    private float[] _nearness = [];
    private int[] _ids = [];
    private (RenderCamera Camera, SampleGrid Grid)? _bentBefore;

    /// <summary>Makes a renderer.</summary>
    public Renderer() => _screen = new ScreenTriangles(_chunks);

    /// <summary>Draws a scene.</summary>
    /// <param name="scene">What there is to see.</param>
    /// <param name="camera">From where.</param>
    /// <param name="target">Where the picture goes; as large as the camera's image.</param>
    /// <exception cref="ArgumentException">The target's size is not the camera's.</exception>
    public void Render(RenderScene scene, RenderCamera camera, RenderTarget target)
    {
        ArgumentNullException.ThrowIfNull(scene);
        ArgumentNullException.ThrowIfNull(camera);
        ArgumentNullException.ThrowIfNull(target);
        if (target.Width != camera.Width || target.Height != camera.Height)
        {
            throw new ArgumentException($"The target is {target.Width}x{target.Height}, but the camera's image {camera.Width}x{camera.Height}.", nameof(target));
        }

        var view = new View(camera, GridOf(camera));
        int bandCount = (camera.Height + BandHeight - 1) / BandHeight;
        CollectPieces(scene, view, bandCount);
        Parallel.For(0, _chunkCount, number => _chunks[number].Process(view, BandHeight));
        if (_ids.Length != target.Depth.Length)
        {
            _ids = new int[target.Depth.Length];
            _nearness = new float[target.Depth.Length];
            _stepped = new byte[target.Colour.Length];
        }

        var shader = new PixelShader(scene, view);
        Parallel.For(0, bandCount, band =>
        {
            int top = band * BandHeight;
            int bottom = Math.Min(camera.Height, top + BandHeight);
            DrawBand(view, band, top, bottom);
            Resolve(shader, view, target, top, bottom);
        });
        new EdgeSmoother(view, _screen, _ids, _nearness).Smooth(target, _stepped);
        Precipitation.Draw(scene.Lighting, target);
    }

    private SampleGrid? GridOf(RenderCamera camera)
    {
        if (camera.Lens.IsRectilinear)
        {
            return null;
        }

        // Where pixels lie in the pinhole's image has nothing to do with where the camera stands.
        RenderCamera unposed = camera with { Pose = default };
        if (_bentBefore is not { } before || before.Camera != unposed)
        {
            _bentBefore = (unposed, new SampleGrid(camera));
        }

        return _bentBefore?.Grid;
    }

    private void CollectPieces(RenderScene scene, View view, int bandCount)
    {
        _chunkCount = 0;
        foreach (InstanceSet set in new[] { scene.Static, scene.Dynamic })
        {
            _instances.Clear();
            set.Hierarchy.AddRangesInside(view.Sides(view.Matrix), _instances);
            foreach ((int first, int count) in _instances)
            {
                foreach (ref readonly MeshInstance instance in set.Instances.Slice(first, count))
                {
                    CollectPieces(instance, view, bandCount);
                }
            }
        }
    }

    private void CollectPieces(in MeshInstance instance, View view, int bandCount)
    {
        _triangles.Clear();
        instance.Mesh.Hierarchy.AddRangesInside(view.Sides(view.Matrix * Matrix4.ToWorld(instance.Pose)), _triangles);
        foreach ((int first, int count) in _triangles)
        {
            for (int done = 0; done < count;)
            {
                TriangleChunk chunk = ChunkWithRoom(bandCount);
                int taken = Math.Min(count - done, TriangleChunk.Capacity - chunk.TriangleCount);
                chunk.Add(new MeshPiece(instance, first + done, taken));
                done += taken;
            }
        }
    }

    private TriangleChunk ChunkWithRoom(int bandCount)
    {
        if (_chunkCount == 0 || _chunks[_chunkCount - 1].TriangleCount == TriangleChunk.Capacity)
        {
            if (_chunkCount == _chunks.Count)
            {
                _chunks.Add(new TriangleChunk());
            }

            _chunks[_chunkCount++].Clear(bandCount);
        }

        return _chunks[_chunkCount - 1];
    }

    private void DrawBand(View view, int band, int top, int bottom)
    {
        int start = top * view.Camera.Width;
        int length = (bottom - top) * view.Camera.Width;
        Array.Clear(_nearness, start, length);
        Array.Fill(_ids, ScreenTriangles.Nothing, start, length);
        for (int number = 0; number < _chunkCount; number++)
        {
            ReadOnlySpan<ScreenTriangle> triangles = _chunks[number].Triangles;
            foreach (int index in _chunks[number].Band(band))
            {
                BandRasteriser.Draw(triangles[index], ScreenTriangles.IdOf(number, index), view, top, bottom, _nearness, _ids);
            }
        }
    }

    private void Resolve(PixelShader shader, View view, RenderTarget target, int top, int bottom)
    {
        var near = (float)view.Camera.NearClip;
        for (int row = top; row < bottom; row++)
        {
            int end = (row + 1) * target.Width;
            for (int pixel = row * target.Width; pixel < end;)
            {
                int id = _ids[pixel];
                int length = _ids.AsSpan(pixel, end - pixel).IndexOfAnyExcept(id);
                length = length < 0 ? end - pixel : length;
                int column = pixel - (row * target.Width);
                Span<byte> colours = target.Colour.AsSpan(pixel * 3, length * 3);
                Span<float> depths = target.Depth.AsSpan(pixel, length);
                if (id == ScreenTriangles.Nothing)
                {
                    target.Handles.AsSpan(pixel, length).Clear();
                    depths.Fill(float.PositiveInfinity);
                    shader.ShadeSky(row, column, colours);
                }
                else
                {
                    ref readonly ScreenTriangle triangle = ref _screen[id];
                    target.Handles.AsSpan(pixel, length).Fill(triangle.Handle);
                    for (int i = 0; i < length; i++)
                    {
                        depths[i] = near / _nearness[pixel + i];
                    }

                    shader.Shade(triangle, row, column, depths, colours);
                }

                pixel += length;
            }
        }
    }
}
