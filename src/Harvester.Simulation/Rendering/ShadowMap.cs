using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// How far towards a light a scene reaches above each texel of a frame: what lies below is in shadow. Only those tiles are drawn that are
/// asked for; a texel's height does not depend on which others are.
/// </summary>
internal sealed class ShadowMap(int size)
{
    private const int SideCount = 4;
    private static readonly int Lanes = Vector256<float>.Count;

    /// <summary>
    /// So many sets of hidden static entities have their heights kept, for pictures of one moment with and without objects.
    /// </summary>
    private const int MaxKept = 4;

    private readonly List<FixedHeights> _kept = [];
    private readonly float[] _heights = new float[size * size];
    private readonly List<(int First, int Count)> _ranges = [];
    private readonly ShadowTiles _wanted = new(size);
    private readonly ShadowTiles _missing = new(size);
    private ShadowFrame _frame;
    private InstanceSet? _drawn;
    private Vector3 _across;
    private Vector3 _along;
    private Vector3 _light;
    private Vector3 _eye;

    /// <summary>Heights with the moving instances.</summary>
    public ReadOnlySpan<float> Heights => _heights;

    /// <summary>The tiles that the next drawing must have.</summary>
    public ShadowTiles Wanted => _wanted;

    /// <summary>Chooses the frame that is drawn next, for places relative to an eye. No tile of it is wanted yet.</summary>
    public void Aim(in ShadowFrame frame, InstanceSet world, Vector3D eye)
    {
        if (_drawn != world || _frame != frame)
        {
            (_drawn, _frame) = (world, frame);
            if (_kept.Count > 1)
            {
                _kept.RemoveRange(1, _kept.Count - 1);
            }

            _kept.ForEach(static kept => kept.Drawn.Clear());
        }

        _wanted.Clear();
        LookFrom(eye);
    }

    /// <summary>
    /// Draws the wanted tiles: the static instances only where they are not drawn since the frame, the world or the static ones that are
    /// hidden became others, then the moving ones.
    /// </summary>
    public void Draw(RenderScene scene)
    {
        HashSet<int>? left = scene.Shadowless;
        float[] still = FixedHeightsOf(scene.Static, left);
        for (int row = 0; row < size; row++)
        {
            for (ulong columns = _wanted.ColumnsAt(row); columns != 0; )
            {
                (int from, int to) = _wanted.TakeStretch(ref columns);
                still.AsSpan((row * size) + from, to - from).CopyTo(_heights.AsSpan((row * size) + from));
            }
        }

        Draw(scene.Dynamic, left, _heights, _wanted);
    }

    private void LookFrom(Vector3D eye)
    {
        double scale = 1 / _frame.TexelMetres;
        (_across, _along, _light) = (Sky.ToSingle(_frame.Across * scale), Sky.ToSingle(_frame.Along * scale), Sky.ToSingle(_frame.Light));
        _eye = new Vector3(
            (float)((_frame.Across.Dot(eye) - _frame.Left) * scale),
            (float)((_frame.Along.Dot(eye) - _frame.Bottom) * scale),
            (float)(_frame.Light.Dot(eye) - _frame.Zero)
        );
    }

    private float[] FixedHeightsOf(InstanceSet world, HashSet<int>? left)
    {
        HashSet<int> hidden = world.HandlesAmong(left);
        FixedHeights? found = _kept.Find(kept => kept.Hidden.SetEquals(hidden));
        if (found is null)
        {
            found = _kept.Find(static kept => kept.Drawn.IsEmpty) ?? (_kept.Count < MaxKept ? new FixedHeights(size) : _kept[0]);
            found.Hidden = hidden;
            found.Drawn.Clear();
        }

        if (_missing.TakeMissing(_wanted, found.Drawn))
        {
            for (int row = 0; row < size; row++)
            {
                for (ulong columns = _missing.ColumnsAt(row); columns != 0; )
                {
                    (int from, int to) = _missing.TakeStretch(ref columns);
                    found.Heights.AsSpan((row * size) + from, to - from).Fill(float.NegativeInfinity);
                }
            }

            Draw(world, left, found.Heights, _missing);
            found.Drawn.Add(_missing);
        }

        _kept.Remove(found);
        _kept.Add(found);
        return found.Heights;
    }

    /// <summary>Places relative to the eye in the map's frame: texels across and along, and metres towards the light.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideVector InMap(in WideVector place) =>
        WideVector.Of(_eye)
        + new WideVector(place.Dot(WideVector.Of(_across)), place.Dot(WideVector.Of(_along)), place.Dot(WideVector.Of(_light)));

    /// <summary>Which places have four texels around them.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> IsWithin(in WideVector inMap)
    {
        Vector256<float> first = Vector256.Create(0.5f);
        Vector256<float> last = Vector256.Create(size - 0.5f);
        return Vector256.GreaterThanOrEqual(inMap.X, first)
            & Vector256.GreaterThanOrEqual(inMap.Y, first)
            & Vector256.LessThan(inMap.X, last)
            & Vector256.LessThan(inMap.Y, last);
    }

    /// <summary>Asks for the tiles from which <see cref="Lit"/> reads; several threads may ask at once.</summary>
    /// <param name="inMap">Places in the map's frame.</param>
    /// <param name="isAsked">For which of them; those are within the map.</param>
    public void Want(in WideVector inMap, Vector256<float> isAsked)
    {
        Vector256<int> texels = TexelsAt(
            Vector256.Floor(inMap.X - Vector256.Create(0.5f)),
            Vector256.Floor(inMap.Y - Vector256.Create(0.5f)),
            size - 2
        );
        for (uint lanes = isAsked.ExtractMostSignificantBits(); lanes != 0; lanes &= lanes - 1)
        {
            _wanted.AddAround(texels[BitOperations.TrailingZeroCount(lanes)]);
        }
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

        // Bilinear weights of the four texels' verdicts, not of their heights: a soft edge one texel wide (percentage closer filtering).
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
            Vector256.Floor(Vector256.MinNative(Vector256.MaxNative(across, Wide.Zero), end))
        );
        Vector256<int> rows = Vector256.ConvertToInt32Native(
            Vector256.Floor(Vector256.MinNative(Vector256.MaxNative(along, Wide.Zero), end))
        );
        return (rows * size) + columns;
    }

    private static Vector256<float> Reaches(Vector256<float> height, ReadOnlySpan<float> near, int corner) =>
        Vector256.GreaterThanOrEqual(height, Vector256.Create(near.Slice(corner * Lanes, Lanes)));

    private void Draw(InstanceSet set, HashSet<int>? left, float[] heights, ShadowTiles tiles)
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
                if (!Reaches(instance.Mesh.Bounds, toMap, tiles))
                {
                    continue;
                }

                foreach (ref readonly MeshTriangle triangle in instance.Mesh.Given)
                {
                    ShadowRasteriser.Draw(toMap.Apply(triangle.A), toMap.Apply(triangle.B), toMap.Apply(triangle.C), heights, size, tiles);
                }
            }
        }
    }

    /// <summary>Whether a box, and a texel around it, reaches into a tile.</summary>
    private bool Reaches(in Bounds bounds, in ClipTransform toMap, ShadowTiles tiles)
    {
        // The box around a turned box: its half sides add up by magnitude.
        Vector3D half = (bounds.Max - bounds.Min) * 0.5;
        Vector256<double> centre = toMap.Apply(bounds.Min + half);
        Vector256<double> reach =
            Vector256.Abs(toMap.AlongX(half.X))
            + Vector256.Abs(toMap.AlongY(half.Y))
            + Vector256.Abs(toMap.AlongZ(half.Z))
            + Vector256<double>.One;
        Vector256<double> end = Vector256.Create((double)size);
        Vector256<double> min = Vector256.Min(Vector256.Max(Vector256.Floor(centre - reach), Vector256<double>.Zero), end);
        Vector256<double> max = Vector256.Min(Vector256.Max(Vector256.Ceiling(centre + reach), Vector256<double>.Zero), end);
        return min[0] < max[0] && min[1] < max[1] && tiles.HasAnyIn((int)min[0], (int)min[1], (int)max[0], (int)max[1]);
    }

    /// <summary>Heights of the static instances of one world in one frame, without some of them.</summary>
    private sealed class FixedHeights(int size)
    {
        public float[] Heights { get; } = new float[size * size];

        public HashSet<int> Hidden { get; set; } = [];

        /// <summary>The tiles in which they are drawn.</summary>
        public ShadowTiles Drawn { get; } = new(size);
    }
}
