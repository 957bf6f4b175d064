using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// How much of the sky places see, from the heights of the scene above and around them: contact shadows, and the dark below bridges and
/// trees.
/// </summary>
internal sealed class SkyView
{
    private const int Texels = 512;
    private const double TexelMetres = 0.25;

    /// <summary>
    /// The sky is looked for around a place that lies so far in front of the surface: farther than the taps, so that a wall does not take
    /// its own sky.
    /// </summary>
    private const float OffsetMetres = 0.75f;
    private const int TapTexels = 1;

    /// <summary>An object so far above a place takes half as much of the sky as one right above it, metres.</summary>
    private const float HalfHeight = 4;

    /// <summary>The fraction of its part of the sky that an object takes at least.</summary>
    private const float MinTaken = 0.3f;

    /// <summary>The fraction of the sky that can be taken: some light is reflected by the ground.</summary>
    private const float MaxTaken = 0.85f;

    private static readonly int[] Taps = [0, TapTexels, -TapTexels, TapTexels * Texels, -TapTexels * Texels];

    private readonly ShadowMap _map = new(Texels);
    private readonly float[] _highestInRow = new float[Texels * Texels];
    private readonly float[] _highest = new float[Texels * Texels];

    /// <summary>Draws what lies around a place, for places relative to an eye.</summary>
    public void Draw(Vector3D place, Vector3D eye, RenderScene scene)
    {
        _map.Aim(ShadowFrame.Around(new Vector3D(0, 0, 1), place, TexelMetres, Texels), scene.Static, eye);
        _map.Wanted.AddAll();
        _map.Draw(scene);
        Spread(_map.Heights, _highestInRow, TapTexels);
        Spread(_highestInRow, _highest, TapTexels * Texels);
    }

    /// <summary>The fraction of the sky's light that reaches places on a surface.</summary>
    /// <param name="place">Places relative to the eye.</param>
    /// <param name="normal">Unit normal of the surface, towards the eye.</param>
    public Vector256<float> At(in WideVector place, Vector3 normal)
    {
        WideVector inMap = _map.InMap(place + WideVector.Of(normal * OffsetMetres));
        Vector256<float> isWithin = _map.IsWithin(inMap);
        Span<int> texels = stackalloc int[Vector256<int>.Count];
        _map.TexelsAt(inMap.X, inMap.Y).CopyTo(texels);
        Vector256<float> highest = Read(_highest, texels, 0);
        if ((Vector256.GreaterThan(highest, inMap.Z) & isWithin) == Wide.Zero)
        {
            return Wide.One;
        }

        Vector256<float> taken = Wide.Zero;
        foreach (int tap in Taps)
        {
            Vector256<float> height = Read(_map.Heights, texels, tap) - inMap.Z;

            // Each tap takes 1 / (1 + (h / HalfHeight)²) of its fifth of the sky, h being the height of what is above it.
            Vector256<float> ratio = height * Vector256.Create(1 / HalfHeight);
            Vector256<float> share = Vector256.MaxNative(Wide.One / (Wide.One + (ratio * ratio)), Vector256.Create(MinTaken));
            taken += share & Vector256.GreaterThan(height, Wide.Zero);
        }

        return Wide.One - (isWithin & (taken * Vector256.Create(MaxTaken / Taps.Length)));
    }

    private static Vector256<float> Read(ReadOnlySpan<float> heights, ReadOnlySpan<int> texels, int tap)
    {
        Span<float> found = stackalloc float[Vector256<float>.Count];
        ref float start = ref MemoryMarshal.GetReference(heights);
        for (int lane = 0; lane < found.Length; lane++)
        {
            found[lane] = Unsafe.Add(ref start, Math.Clamp(texels[lane] + tap, 0, heights.Length - 1));
        }

        return Vector256.Create<float>(found);
    }

    /// <summary>The highest of each texel and those a step before and after it.</summary>
    private static void Spread(ReadOnlySpan<float> from, Span<float> to, int step)
    {
        from[..step].CopyTo(to);
        from[^step..].CopyTo(to[^step..]);
        int end = from.Length - step;
        int texel = step;
        for (; texel <= end - Vector256<float>.Count; texel += Vector256<float>.Count)
        {
            Vector256
                .Max(
                    Vector256.Create(from.Slice(texel, Vector256<float>.Count)),
                    Vector256.Max(
                        Vector256.Create(from.Slice(texel - step, Vector256<float>.Count)),
                        Vector256.Create(from.Slice(texel + step, Vector256<float>.Count))
                    )
                )
                .CopyTo(to[texel..]);
        }

        for (; texel < end; texel++)
        {
            to[texel] = Math.Max(from[texel], Math.Max(from[texel - step], from[texel + step]));
        }
    }
}
