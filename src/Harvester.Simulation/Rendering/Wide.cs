using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>Functions of eight numbers at a time, the same on every processor.</summary>
internal static class Wide
{
    private const float Log2E = 1.44269504f;
    private const float Ln2 = 0.69314718f;

    /// <summary>Below this power of two single precision has no full accuracy.</summary>
    private const float MinPower = -126;

    private const int MantissaBits = 23;
    private const int ExponentBias = 127;

    public static Vector256<float> Zero => Vector256<float>.Zero;

    public static Vector256<float> One => Vector256<float>.One;

    /// <summary>Held to the range from 0 to 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Fraction(Vector256<float> value) => Vector256.MinNative(Vector256.MaxNative(value, Zero), One);

    /// <summary>e to a power of 0 or less, to 1 part in 100,000.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Exp(Vector256<float> power)
    {
        // e^x = 2^(x log2 e) = 2^whole · e^(rest), where the whole power of two goes into the exponent of the number.
        Vector256<float> ofTwo = Vector256.MaxNative(power * Vector256.Create(Log2E), Vector256.Create(MinPower));
        Vector256<float> whole = Vector256.Floor(ofTwo);
        Vector256<float> rest = (ofTwo - whole) * Vector256.Create(Ln2);

        // The series of e^rest for rest below ln 2; the first term left out, rest⁷ / 5040, is below 1.6e-5 where e^rest is nearly 2.
        Vector256<float> series =
            One
            + (
                rest
                * (
                    One
                    + (
                        rest
                        * (
                            Vector256.Create(1 / 2f)
                            + (
                                rest
                                * (
                                    Vector256.Create(1 / 6f)
                                    + (
                                        rest
                                        * (
                                            Vector256.Create(1 / 24f)
                                            + (rest * (Vector256.Create(1 / 120f) + (rest * Vector256.Create(1 / 720f))))
                                        )
                                    )
                                )
                            )
                        )
                    )
                )
            );
        Vector256<int> exponent = (Vector256.ConvertToInt32(whole) + Vector256.Create(ExponentBias)) << MantissaBits;
        return series * exponent.AsSingle();
    }
}
