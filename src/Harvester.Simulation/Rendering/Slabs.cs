using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A box prepared for ray tests: its three pairs of faces are tested at once.</summary>
internal readonly struct Slabs(in Bounds box)
{
    // The fourth pair of faces is infinitely far away, so that it never decides.
    private readonly Vector256<double> _min = Vector256.Create(box.Min.X, box.Min.Y, box.Min.Z, double.NegativeInfinity);
    private readonly Vector256<double> _max = Vector256.Create(box.Max.X, box.Max.Y, box.Max.Z, double.PositiveInfinity);

    /// <summary>A point in the form that <see cref="Entry"/> expects.</summary>
    public static Vector256<double> Origin(Vector3D origin) => Vector256.Create(origin.X, origin.Y, origin.Z, 0);

    /// <summary>The reciprocals of a direction's components in the form that <see cref="Entry"/> expects.</summary>
    public static Vector256<double> Inverse(Vector3D direction) =>
        Vector256.Create(Inverse(direction.X), Inverse(direction.Y), Inverse(direction.Z), 1);

    /// <summary>Where a ray enters the box; infinity when it misses.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Entry(Vector256<double> origin, Vector256<double> inverse, double limit)
    {
        Vector256<double> a = (_min - origin) * inverse;
        Vector256<double> b = (_max - origin) * inverse;
        Vector256<double> near = Vector256.MinNative(a, b);
        Vector256<double> far = Vector256.MaxNative(a, b);
        Vector128<double> lastTwo = Vector128.MaxNative(near.GetLower(), near.GetUpper());
        Vector128<double> firstTwo = Vector128.MinNative(far.GetLower(), far.GetUpper());
        double last = lastTwo[0] > lastTwo[1] ? lastTwo[0] : lastTwo[1];
        double first = firstTwo[0] < firstTwo[1] ? firstTwo[0] : firstTwo[1];
        double entry = last > 0 ? last : 0;
        double exit = first < limit ? first : limit;

        // Rounding must not lose a hit exactly on the edge of a box.
        const double room = 1 + 1e-12;
        return entry <= exit * room ? entry : double.PositiveInfinity;
    }

    /// <summary>A finite substitute for 1 / 0, so that a ray along a face gives 0 and not NaN.</summary>
    private static double Inverse(double component) => component == 0 ? 1e300 : 1 / component;
}
