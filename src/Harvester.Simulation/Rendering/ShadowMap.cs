using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>How far towards a light a scene reaches above each texel of a frame: what lies below is in shadow.</summary>
internal sealed class ShadowMap(int size)
{
    private const int SideCount = 4;
    private static readonly int Lanes = Vector256<float>.Count;

    /// <summary>
    /// So many sets of hidden static entities have their heights kept, for pictures of one moment with and without objects.
    /// </summary>
    private const int MostKept = 4;

    private readonly List<FixedHeights> _kept = [];
    private readonly float[] _heights = new float[size * size];
    private readonly List<(int First, int Count)> _ranges = [];
    private ShadowFrame _frame;
    private InstanceSet? _drawn;
    private Vector3 _across;
    private Vector3 _along;
    private Vector3 _light;
    private Vector3 _eye;

    /// <summary>Heights with the moving instances.</summary>
    public ReadOnlySpan<float> Heights => _heights;

    /// <summary>
    /// Draws the instances that reach into a frame: the static ones only if the frame, the world or the static ones that are hidden are
    /// others than before, then the moving ones.
    /// </summary>
    public void Draw(in ShadowFrame frame, RenderScene scene)
    {
        HashSet<int>? left = scene.Shadowless;
        FixedHeightsOf(frame, scene.Static, left).CopyTo(_heights, 0);
        Draw(scene.Dynamic, left, _heights);
    }

    private float[] FixedHeightsOf(in ShadowFrame frame, InstanceSet world, HashSet<int>? left)
    {
        if (_drawn != world || _frame != frame)
        {
            (_drawn, _frame) = (world, frame);
            if (_kept.Count > 1)
            {
                _kept.RemoveRange(1, _kept.Count - 1);
            }

            _kept.ForEach(static kept => kept.IsDrawn = false);
        }

        HashSet<int> hidden = world.HandlesAmong(left);
        FixedHeights? found = _kept.Find(kept => kept.IsDrawn && kept.Hidden.SetEquals(hidden));
        if (found is null)
        {
            found = _kept.Find(static kept => !kept.IsDrawn) ?? (_kept.Count < MostKept ? new FixedHeights(size * size) : _kept[0]);
            Array.Fill(found.Heights, float.NegativeInfinity);
            Draw(world, left, found.Heights);
            (found.IsDrawn, found.Hidden) = (true, hidden);
        }

        _kept.Remove(found);
        _kept.Add(found);
        return found.Heights;
    }

    /// <summary>Prepares for places relative to an eye.</summary>
    public void LookFrom(Vector3D eye)
    {
        double scale = 1 / _frame.TexelMetres;
        (_across, _along, _light) = (Sky.ToSingle(_frame.Across * scale), Sky.ToSingle(_frame.Along * scale), Sky.ToSingle(_frame.Light));
        _eye = new Vector3(
            (float)((_frame.Across.Dot(eye) - _frame.Left) * scale),
            (float)((_frame.Along.Dot(eye) - _frame.Bottom) * scale),
            (float)(_frame.Light.Dot(eye) - _frame.Zero));
    }

    /// <summary>Places relative to the eye in the map's frame: texels across and along, and metres towards the light.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideVector InMap(in WideVector place) => WideVector.Of(_eye)
        + new WideVector(place.Dot(WideVector.Of(_across)), place.Dot(WideVector.Of(_along)), place.Dot(WideVector.Of(_light)));

    /// <summary>Which places have four texels around them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> IsWithin(in WideVector inMap)
    {
        Vector256<float> first = Vector256.Create(0.5f);
        Vector256<float> last = Vector256.Create(size - 0.5f);
        return Vector256.GreaterThanOrEqual(inMap.X, first) & Vector256.GreaterThanOrEqual(inMap.Y, first)
            & Vector256.LessThan(inMap.X, last) & Vector256.LessThan(inMap.Y, last);
    }

    /// <summary>The fraction of light that reaches places within the map, from the four nearest texels.</summary>
    public Vector256<float> Lit(in WideVector inMap)
    {
        Vector256<float> x = inMap.X - Vector256.Create(0.5f);
        Vector256<float> y = inMap.Y - Vector256.Create(0.5f);
        Vector256<float> column = Vector256.Floor(x);
        Vector256<float> row = Vector256.Floor(y);
        Span<int> texels = stackalloc int[Lanes];
        TexelsAt(column, row, size - 2).CopyTo(texels);
        Span<float> near = stackalloc float[4 * Lanes];
        ref float heights = ref MemoryMarshal.GetArrayDataReference(_heights);
        for (int lane = 0; lane < texels.Length; lane++)
        {
            ref float texel = ref Unsafe.Add(ref heights, texels[lane]);
            near[lane] = texel;
            near[lane + Lanes] = Unsafe.Add(ref texel, 1);
            near[lane + (2 * Lanes)] = Unsafe.Add(ref texel, size);
            near[lane + (3 * Lanes)] = Unsafe.Add(ref texel, size + 1);
        }

        Vector256<float> toRight = x - column;
        Vector256<float> toLeft = Wide.One - toRight;
        Vector256<float> upward = y - row;
        return ((Wide.One - upward) * ((toLeft & Reaches(inMap.Z, near, 0)) + (toRight & Reaches(inMap.Z, near, 1))))
            + (upward * ((toLeft & Reaches(inMap.Z, near, 2)) + (toRight & Reaches(inMap.Z, near, 3))));
    }

    /// <summary>The numbers of the texels that places are in; of a place outside the map that of some texel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<int> TexelsAt(Vector256<float> across, Vector256<float> along) => TexelsAt(across, along, size - 1);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Vector256<int> TexelsAt(Vector256<float> across, Vector256<float> along, int last)
    {
        Vector256<float> end = Vector256.Create((float)last);
        Vector256<int> columns = Vector256.ConvertToInt32Native(
            Vector256.Floor(Vector256.MinNative(Vector256.MaxNative(across, Wide.Zero), end)));
        Vector256<int> rows = Vector256.ConvertToInt32Native(
            Vector256.Floor(Vector256.MinNative(Vector256.MaxNative(along, Wide.Zero), end)));
        return (rows * size) + columns;
    }

    private static Vector256<float> Reaches(Vector256<float> height, ReadOnlySpan<float> near, int corner) =>
        Vector256.GreaterThanOrEqual(height, Vector256.Create(near.Slice(corner * Lanes, Lanes)));

    private void Draw(InstanceSet set, HashSet<int>? left, float[] heights)
    {
        Span<Plane> sides = stackalloc Plane[SideCount];
        _frame.WriteSides(sides);
        _ranges.Clear();
        set.Hierarchy.AddRangesInside(sides, _ranges);
        Matrix4 fromWorld = _frame.FromWorld;
        foreach ((int first, int count) in _ranges)
        {
            foreach (ref readonly MeshInstance instance in set.Instances.Slice(first, count))
            {
                if (left?.Contains(instance.Handle) == true || !instance.Mesh.CastsShadows)
                {
                    continue;
                }

                var toMap = new ClipTransform(fromWorld * Matrix4.ToWorld(instance.Pose));
                foreach (ref readonly MeshTriangle triangle in instance.Mesh.Given)
                {
                    Draw(toMap.Apply(triangle.A), toMap.Apply(triangle.B), toMap.Apply(triangle.C), heights);
                }
            }
        }
    }

    /// <summary>Raises the texels whose centres a triangle covers.</summary>
    private void Draw(Vector256<double> a, Vector256<double> b, Vector256<double> c, float[] heights)
    {
        Vector256<double> min = Vector256.MinNative(a, Vector256.MinNative(b, c));
        Vector256<double> max = Vector256.MaxNative(a, Vector256.MaxNative(b, c));
        int left = (int)Math.Clamp(Math.Ceiling(min[0] - 0.5), 0, size);
        int right = (int)Math.Clamp(Math.Ceiling(max[0] - 0.5), 0, size);
        int bottom = (int)Math.Clamp(Math.Ceiling(min[1] - 0.5), 0, size);
        int top = (int)Math.Clamp(Math.Ceiling(max[1] - 0.5), 0, size);
        double doubleArea = ((b[0] - a[0]) * (c[1] - a[1])) - ((b[1] - a[1]) * (c[0] - a[0]));
        if (left >= right || bottom >= top || doubleArea == 0)
        {
            return;
        }

        EdgeTriple edges = doubleArea > 0 ? new EdgeTriple(a, b, c) : new EdgeTriple(b, a, c);
        Vector256<double> ab = b - a;
        Vector256<double> ac = c - a;
        double stepX = ((ab[2] * ac[1]) - (ac[2] * ab[1])) / doubleArea;
        double stepY = ((ac[2] * ab[0]) - (ab[2] * ac[0])) / doubleArea;
        for (int row = bottom; row < top; row++)
        {
            (int first, int last) = edges.ColumnsInside(row + 0.5, left, right);
            double height = a[2] + (stepX * (first + 0.5 - a[0])) + (stepY * (row + 0.5 - a[1]));
            Span<float> texels = heights.AsSpan((row * size) + first, Math.Max(0, last - first));
            for (int i = 0; i < texels.Length; i++)
            {
                texels[i] = Math.Max(texels[i], (float)(height + (stepX * i)));
            }
        }
    }

    /// <summary>Heights of the static instances of one world in one frame, without some of them.</summary>
    private sealed class FixedHeights(int texels)
    {
        public float[] Heights { get; } = new float[texels];

        public HashSet<int> Hidden { get; set; } = [];

        public bool IsDrawn { get; set; }
    }
}
