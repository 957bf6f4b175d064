using System.Numerics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Draws a scene on the processor: meshes through 4x4 matrices into a z-buffer, bands of rows in parallel, then light and fog for each
/// pixel. Pixel (i, j) shows what lies at its centre (i + 0.5, j + 0.5); both sides of a triangle are drawn. The same scene and camera give
/// the same bytes. A renderer reuses its buffers from frame to frame and serves one caller at a time.
/// </summary>
public sealed class Renderer
{
    /// <summary>How far the first batch of instances reaches, metres.</summary>
    private const double FirstReachMetres = 12;

    private readonly List<TriangleChunk> _chunks = [];
    private readonly List<(int First, int Count)> _ranges = [];
    private readonly List<SeenInstance> _seen = [];
    private PixelRow[] _rows = [];
    private DepthTiles _tiles = new(1, 1);
    private (int Width, int Height) _tilesOf = (1, 1);
    private int _chunkCount;
    private readonly ScreenTriangles _screen;
    private byte[] _stepped = [];
    private float[] _nearness = [];
    private int[] _ids = [];
    private (RenderCamera Camera, SampleGrid Grid)? _bentBefore;

    private readonly SceneShadows? _shadows;
    private readonly ShadowRequests? _requests;
    private readonly MarkingLayer? _markings;

    /// <summary>Creates a renderer.</summary>
    /// <param name="detail">How much of the light is worked out.</param>
    public Renderer(Detail detail = Detail.Plain)
    {
        _screen = new ScreenTriangles(_chunks);
        if (detail == Detail.Full)
        {
            (_shadows, _markings) = (new SceneShadows(), new MarkingLayer());
            _requests = new ShadowRequests(_shadows, _screen);
        }
    }

    /// <summary>Triangles of the last picture that were brought onto the screen, hidden ones included.</summary>
    internal int TrianglesDrawn
    {
        get
        {
            int drawn = 0;
            for (int number = 0; number < _chunkCount; number++)
            {
                drawn += _chunks[number].Triangles.Length;
            }

            return drawn;
        }
    }

    /// <summary>Draws a scene.</summary>
    /// <param name="scene">What to draw.</param>
    /// <param name="camera">The camera.</param>
    /// <param name="target">Receives the image; it has the size of the camera's image.</param>
    /// <exception cref="ArgumentException">The target's size is not the camera's.</exception>
    public void Render(RenderScene scene, RenderCamera camera, RenderTarget target)
    {
        ArgumentNullException.ThrowIfNull(scene);
        ArgumentNullException.ThrowIfNull(camera);
        ArgumentNullException.ThrowIfNull(target);
        if (target.Width != camera.Width || target.Height != camera.Height)
        {
            throw new ArgumentException(
                $"The target is {target.Width}x{target.Height}, but the camera's image is {camera.Width}x{camera.Height}.",
                nameof(target)
            );
        }

        var view = new View(camera, GridOf(camera));
        int bandCount = (camera.Height + DepthTiles.Size - 1) / DepthTiles.Size;
        if (_ids.Length != target.Depth.Length)
        {
            _ids = new int[target.Depth.Length];
            _nearness = new float[target.Depth.Length];
            _stepped = new byte[target.Colour.Length];
        }

        if (_tilesOf != (camera.Width, camera.Height))
        {
            _tiles = new DepthTiles(camera.Width, camera.Height);
            _tilesOf = (camera.Width, camera.Height);
            _rows = new PixelRow[bandCount];
            for (int band = 0; band < bandCount; band++)
            {
                _rows[band] = new PixelRow(camera.Width);
            }
        }

        Array.Clear(_nearness);
        Array.Fill(_ids, ScreenTriangles.Nothing);
        _markings?.Clear(camera.Width, camera.Height);
        FindInstances(scene, view);
        DrawInstances(view, bandCount);

        _markings?.Project(view, _tiles);
        var shader = new PixelShader(scene, view, _shadows, _markings);
        _requests?.Draw(shader, scene, camera, _rows, _ids, _nearness);
        Parallel.For(
            0,
            bandCount,
            band =>
            {
                int top = band * DepthTiles.Size;
                int bottom = Math.Min(camera.Height, top + DepthTiles.Size);
                _markings?.Draw(view, top, bottom, _nearness);
                Resolve(shader, target, _rows[band], top, bottom);
            }
        );
        if (_shadows is not null && scene.Lighting.RainFraction > 0)
        {
            new WetGround(view, _screen, _ids, _nearness).Reflect(scene.Lighting.RainFraction, target, _stepped);
        }

        new EdgeSmoother(view, _screen, _ids, _nearness).Smooth(target, _stepped);
        Precipitation.Draw(scene.Lighting, target);
    }

    /// <summary>
    /// Unit normals, world, of what is visible at the centres of the pixels of the last picture, row by row and on the camera's side; zero
    /// for the sky.
    /// </summary>
    public Vector3[] NormalsOfLast()
    {
        var normals = new Vector3[_ids.Length];
        for (int i = 0; i < normals.Length; i++)
        {
            normals[i] = _ids[i] == ScreenTriangles.Nothing ? Vector3.Zero : _screen[_ids[i]].Normal;
        }

        return normals;
    }

    private SampleGrid? GridOf(RenderCamera camera)
    {
        if (camera.Lens.IsRectilinear)
        {
            return null;
        }

        // The positions of pixels in the pinhole image do not depend on the camera's pose.
        RenderCamera unposed = camera with
        {
            Pose = default,
        };
        if (_bentBefore is not { } before || before.Camera != unposed)
        {
            _bentBefore = (unposed, new SampleGrid(camera));
        }

        return _bentBefore?.Grid;
    }

    /// <summary>Finds the instances that may be in view, the nearest first.</summary>
    private void FindInstances(RenderScene scene, View view)
    {
        _seen.Clear();
        Span<Plane> sides = stackalloc Plane[View.SideCount];
        view.WriteSides(view.Matrix, sides);
        foreach (InstanceSet set in new[] { scene.Static, scene.Dynamic })
        {
            _ranges.Clear();
            set.Hierarchy.AddRangesInside(sides, _ranges);
            foreach ((int first, int count) in _ranges)
            {
                foreach (ref readonly MeshInstance instance in set.Instances.Slice(first, count))
                {
                    if (scene.IsHidden(instance.Handle))
                    {
                        continue;
                    }

                    var toClip = new ClipTransform(view.Matrix * Matrix4.ToWorld(instance.Pose));
                    ScreenBox? box = ScreenBox.Of(instance.Mesh.Bounds, toClip, view);
                    if (_markings is not null && instance.Mesh.IsMarking)
                    {
                        _markings.Add(instance);
                    }
                    else if (box is not { Pixels.IsEmpty: true })
                    {
                        _seen.Add(new SeenInstance(instance, box is { } onScreen ? view.NearClip / onScreen.Nearness : 0, _seen.Count));
                    }
                }
            }
        }

        _seen.Sort();
    }

    /// <summary>
    /// Draws instances in batches that reach twice as far each: what nearer ones hide is skipped. Batches do
    /// not depend on how the work is shared out, so the picture does not either.
    /// </summary>
    private void DrawInstances(View view, int bandCount)
    {
        _chunkCount = 0;
        _tiles.Clear();
        double reach = FirstReachMetres;
        for (int next = 0; next < _seen.Count; reach *= 2)
        {
            int firstChunk = _chunkCount;
            for (; next < _seen.Count && _seen[next].Depth < reach; next++)
            {
                Add(_seen[next].Instance, firstChunk, bandCount);
            }

            if (firstChunk < _chunkCount)
            {
                Parallel.For(firstChunk, _chunkCount, number => _chunks[number].Process(view, _tiles, DepthTiles.Size));
                Parallel.For(0, bandCount, band => DrawBand(view, band, firstChunk));
            }
        }
    }

    private void Add(in MeshInstance instance, int firstChunk, int bandCount)
    {
        int count = instance.Mesh.Triangles.Length;
        for (int done = 0; done < count; )
        {
            TriangleChunk chunk = ChunkWithRoom(firstChunk, bandCount);
            int taken = Math.Min(count - done, TriangleChunk.Capacity - chunk.TriangleCount);
            chunk.Add(new MeshPiece(instance, done, taken));
            done += taken;
        }
    }

    private TriangleChunk ChunkWithRoom(int firstChunk, int bandCount)
    {
        if (_chunkCount == firstChunk || _chunks[_chunkCount - 1].TriangleCount == TriangleChunk.Capacity)
        {
            if (_chunkCount == _chunks.Count)
            {
                _chunks.Add(new TriangleChunk());
            }

            _chunks[_chunkCount++].Clear(bandCount);
        }

        return _chunks[_chunkCount - 1];
    }

    private void DrawBand(View view, int band, int firstChunk)
    {
        int top = band * DepthTiles.Size;
        int bottom = Math.Min(view.Camera.Height, top + DepthTiles.Size);
        for (int number = firstChunk; number < _chunkCount; number++)
        {
            ReadOnlySpan<ScreenTriangle> triangles = _chunks[number].Triangles;
            foreach (int index in _chunks[number].Band(band))
            {
                BandRasteriser.Draw(triangles[index], ScreenTriangles.IdOf(number, index), view, top, bottom, _nearness, _ids);
            }
        }

        _tiles.Update(band, _nearness);
    }

    private void Resolve(PixelShader shader, RenderTarget target, PixelRow row, int top, int bottom)
    {
        int width = target.Width;
        for (int number = top; number < bottom; number++)
        {
            row.Number = number;
            ReadOnlySpan<int> ids = _ids.AsSpan(number * width, width);
            Span<int> handles = target.Handles.AsSpan(number * width, width);
            Span<SurfaceKind> kinds = target.Kinds.AsSpan(number * width, width);
            shader.Begin(row, _nearness.AsSpan(number * width, width));
            for (int column = 0; column < width; )
            {
                int id = ids[column];
                int length = ShadowRequests.LengthOf(ids[column..]);
                if (id == ScreenTriangles.Nothing)
                {
                    handles.Slice(column, length).Clear();
                    kinds.Slice(column, length).Fill(SurfaceKind.Sky);
                    shader.ShadeSky(row, column, length);
                }
                else
                {
                    ref readonly ScreenTriangle triangle = ref _screen[id];
                    handles.Slice(column, length).Fill(triangle.Handle);
                    kinds.Slice(column, length).Fill(triangle.Kind);
                    shader.Shade(triangle, row, column, length);
                }

                column += length;
            }

            _markings?.AddTo(kinds, number);
            row.Depths.AsSpan(0, width).CopyTo(target.Depth.AsSpan(number * width, width));
            row.CopyTo(target.Colour.AsSpan(number * width * 3, width * 3));
        }
    }
}
