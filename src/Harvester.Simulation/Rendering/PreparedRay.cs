using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A ray prepared for tests against the boxes of a <see cref="RayNode"/>. A test in single precision may report a box that the ray just
/// misses, but never misses one that it hits: the origin is rounded to the side that makes entries earlier and exits later, and
/// <see cref="Slack"/> covers the other roundings.
/// </summary>
internal readonly struct PreparedRay
{
    /// <summary>
    /// Entry and exit have three roundings each, of the difference, the reciprocal and the product: 6 / 2^24 in all, and this is 8 / 2^24.
    /// A limit has one rounding of its own, and is compared with entries only.
    /// </summary>
    private const float Slack = 1 + (1f / (1 << 21));

    /// <summary>
    /// Maximum reciprocal of a component of the direction. It is finite, so that no product is undefined, and takes the smallest difference
    /// of coordinates beyond any scene.
    /// </summary>
    private const double MaxReciprocal = 1e30;

    /// <summary>By how much a coordinate of the origin is moved, relative to itself: at least its distance to the next number.</summary>
    private const float RelativeShift = 1f / (1 << 23);

    /// <summary>The same for an origin of 0; times <see cref="MaxReciprocal"/>, it is farther than any scene.</summary>
    private const float MinShift = 1e-20f;

    private readonly Axis _x;
    private readonly Axis _y;
    private readonly Axis _z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public PreparedRay(Vector3D origin, Vector3D direction)
    {
        _x = new Axis(origin.X, direction.X);
        _y = new Axis(origin.Y, direction.Y);
        _z = new Axis(origin.Z, direction.Z);
    }

    /// <summary>The value of an entry up to which a box may contain a hit that is at most so far away.</summary>
    public static float Reach(double limit) => (float)limit * Slack;

    /// <summary>Tests the boxes of a node.</summary>
    /// <param name="node">The node.</param>
    /// <param name="reach">How far the ray goes, see <see cref="Reach"/>.</param>
    /// <param name="entries">Where the ray enters each box that it hits; 0 if it starts inside.</param>
    /// <returns>A bit for each box, set if the ray hits it.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Hits(in RayNode node, float reach, out Vector256<float> entries)
    {
        Vector256<float> nearX = _x.Entry(node.MinX, node.MaxX);
        Vector256<float> nearY = _y.Entry(node.MinY, node.MaxY);
        Vector256<float> nearZ = _z.Entry(node.MinZ, node.MaxZ);
        Vector256<float> farX = _x.Exit(node.MinX, node.MaxX);
        Vector256<float> farY = _y.Exit(node.MinY, node.MaxY);
        Vector256<float> farZ = _z.Exit(node.MinZ, node.MaxZ);
        entries = Vector256.MaxNative(Vector256.MaxNative(nearX, nearY), Vector256.MaxNative(nearZ, Vector256<float>.Zero));
        Vector256<float> exits = Vector256.MinNative(Vector256.MinNative(farX, farY), farZ) * Vector256.Create(Slack);
        return Vector256.LessThanOrEqual(entries, Vector256.MinNative(exits, Vector256.Create(reach))).ExtractMostSignificantBits();
    }

    /// <summary>One coordinate of the ray, the same in all places of a vector.</summary>
    private readonly struct Axis
    {
        private readonly Vector256<float> _forEntry;
        private readonly Vector256<float> _forExit;
        private readonly Vector256<float> _reciprocal;
        private readonly Vector256<float> _backwards;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Axis(double origin, double direction)
        {
            bool backwards = direction < 0;
            float single = (float)origin;
            float shift = (MathF.Abs(single) * RelativeShift) + MinShift;
            _forEntry = Vector256.Create(backwards ? single - shift : single + shift);
            _forExit = Vector256.Create(backwards ? single + shift : single - shift);
            double reciprocal = 1 / direction;
            _reciprocal = Vector256.Create(
                (float)(backwards ? double.Max(reciprocal, -MaxReciprocal) : double.Min(double.Abs(reciprocal), MaxReciprocal))
            );
            _backwards = backwards ? Vector256<float>.AllBitsSet : Vector256<float>.Zero;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector256<float> Entry(Vector256<float> min, Vector256<float> max) =>
            (Vector256.ConditionalSelect(_backwards, max, min) - _forEntry) * _reciprocal;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Vector256<float> Exit(Vector256<float> min, Vector256<float> max) =>
            (Vector256.ConditionalSelect(_backwards, min, max) - _forExit) * _reciprocal;
    }
}
