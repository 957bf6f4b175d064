namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>
/// The discrete cosine transform of eight values according to Loeffler, Ligtenberg and Moschytz (1989), with 13 fractional bits, as in
/// libjpeg's "islow": once along the rows of a block, once along its columns. The results are 8 times the coefficients of T.81.
/// </summary>
/// <typeparam name="T">An integer, or a vector of integers that are transformed side by side.</typeparam>
/// <typeparam name="TLanes">Its arithmetic.</typeparam>
internal static class ForwardDct<T, TLanes>
    where TLanes : struct, ILanes<T>
{
    private const int FractionBits = 13;

    /// <summary>Fractional bits that the values keep between the two passes.</summary>
    private const int KeptBits = 2;

    // Round(c * 2^13); the names are libjpeg's.
    private const int Fix0298631336 = 2446;
    private const int Fix0390180644 = 3196;
    private const int Fix0541196100 = 4433;
    private const int Fix0765366865 = 6270;
    private const int Fix0899976223 = 7373;
    private const int Fix1175875602 = 9633;
    private const int Fix1501321110 = 12299;
    private const int Fix1847759065 = 15137;
    private const int Fix1961570560 = 16069;
    private const int Fix2053119869 = 16819;
    private const int Fix2562915447 = 20995;
    private const int Fix3072711026 = 25172;

    /// <summary>Transforms eight values in place: the first pass.</summary>
    /// <param name="values">The array of the values.</param>
    /// <param name="start">Index of the first.</param>
    /// <param name="step">Distance from one to the next.</param>
    public static void FirstPass(T[] values, int start, int step)
    {
        TLanes lanes = default;
        (T sum, T difference) = Transform(values, start, step, FractionBits - KeptBits);
        values[start] = lanes.ShiftedLeft(sum, KeptBits);
        values[start + (4 * step)] = lanes.ShiftedLeft(difference, KeptBits);
    }

    /// <summary>Transforms eight results of the first pass in place, across its direction.</summary>
    /// <param name="values">The array of the values.</param>
    /// <param name="start">Index of the first.</param>
    /// <param name="step">Distance from one to the next.</param>
    public static void SecondPass(T[] values, int start, int step)
    {
        TLanes lanes = default;
        (T sum, T difference) = Transform(values, start, step, FractionBits + KeptBits);
        values[start] = lanes.Rounded(sum, KeptBits);
        values[start + (4 * step)] = lanes.Rounded(difference, KeptBits);
    }

    /// <summary>Transforms all but the values 0 and 4, which are returned unscaled: they have no fractional bits.</summary>
    private static (T Sum, T Difference) Transform(T[] values, int start, int step, int bits)
    {
        TLanes lanes = default;
        T first = values[start];
        T second = values[start + step];
        T third = values[start + (2 * step)];
        T fourth = values[start + (3 * step)];
        T fifth = values[start + (4 * step)];
        T sixth = values[start + (5 * step)];
        T seventh = values[start + (6 * step)];
        T eighth = values[start + (7 * step)];

        // The even coefficients come from the sums of values that mirror each other, by a transform of four; a rotation by √2 cos(3π/8) and
        // √2 sin(3π/8) takes three products instead of four.
        T outer = lanes.Sum(first, eighth);
        T nextOuter = lanes.Sum(second, seventh);
        T nextInner = lanes.Sum(third, sixth);
        T inner = lanes.Sum(fourth, fifth);
        T even = lanes.Sum(outer, inner);
        T evenNext = lanes.Sum(nextOuter, nextInner);
        T oddNext = lanes.Difference(nextOuter, nextInner);
        T odd = lanes.Difference(outer, inner);
        T turned = lanes.Product(lanes.Sum(oddNext, odd), Fix0541196100);
        values[start + (2 * step)] = lanes.Rounded(lanes.Sum(turned, lanes.Product(odd, Fix0765366865)), bits);
        values[start + (6 * step)] = lanes.Rounded(lanes.Difference(turned, lanes.Product(oddNext, Fix1847759065)), bits);

        // The odd ones come from the differences; with sums shared between them, nine products do.
        T a = lanes.Difference(fourth, fifth);
        T b = lanes.Difference(third, sixth);
        T c = lanes.Difference(second, seventh);
        T d = lanes.Difference(first, eighth);
        T ac = lanes.Sum(a, c);
        T bd = lanes.Sum(b, d);
        T all = lanes.Product(lanes.Sum(ac, bd), Fix1175875602);
        T ad = lanes.Product(lanes.Sum(a, d), Fix0899976223);
        T bc = lanes.Product(lanes.Sum(b, c), Fix2562915447);
        ac = lanes.Difference(all, lanes.Product(ac, Fix1961570560));
        bd = lanes.Difference(all, lanes.Product(bd, Fix0390180644));
        values[start + (7 * step)] = lanes.Rounded(lanes.Sum(lanes.Difference(lanes.Product(a, Fix0298631336), ad), ac), bits);
        values[start + (5 * step)] = lanes.Rounded(lanes.Sum(lanes.Difference(lanes.Product(b, Fix2053119869), bc), bd), bits);
        values[start + (3 * step)] = lanes.Rounded(lanes.Sum(lanes.Difference(lanes.Product(c, Fix3072711026), bc), ac), bits);
        values[start + step] = lanes.Rounded(lanes.Sum(lanes.Difference(lanes.Product(d, Fix1501321110), ad), bd), bits);
        return (lanes.Sum(even, evenNext), lanes.Difference(even, evenNext));
    }
}
