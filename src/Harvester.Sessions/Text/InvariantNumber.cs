using System.Globalization;
using System.Text;

namespace Harvester.Sessions.Text;

/// <summary>
/// Writes numbers to files in the one way that all files use: rounded half away from zero to the last decimal, and written digit by digit.
/// The formats of .NET Framework and .NET differ (2.675 with two decimals is 2.68 in one and 2.67 in the other), so they are not used. No
/// exponent, no trailing zeros, no negative zero.
/// </summary>
public static class InvariantNumber
{
    /// <summary>Maximum number of decimals.</summary>
    public const int MaxDecimals = 12;

    /// <summary>Below this, doubles represent every integer and every half exactly.</summary>
    private const double MaxScaled = 4_503_599_627_370_496;

    private static readonly double[] PowersOfTen = [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12];

    /// <summary>Appends a number, rounded half away from zero.</summary>
    /// <param name="target">Receives the text.</param>
    /// <param name="value">The number; finite.</param>
    /// <param name="decimals">Maximum number of digits after the point, 0 to 12.</param>
    /// <exception cref="ArgumentOutOfRangeException">
    /// The number is not finite or has more than 15 digits, or the decimals are out of range.
    /// </exception>
    public static void Append(StringBuilder target, double value, int decimals)
    {
        if (target is null)
        {
            throw new ArgumentNullException(nameof(target));
        }

        if (decimals is < 0 or > MaxDecimals)
        {
            throw new ArgumentOutOfRangeException(nameof(decimals), decimals, "A number is written with 0 to 12 decimals.");
        }

        double scaled = Math.Floor((Math.Abs(value) * PowersOfTen[decimals]) + 0.5);
        if (!(scaled <= MaxScaled))
        {
            throw new ArgumentOutOfRangeException(
                nameof(value),
                value,
                FormattableString.Invariant($"{value} cannot be written with {decimals} decimals.")
            );
        }

        long digits = (long)scaled;
        if (digits == 0)
        {
            target.Append('0');
            return;
        }

        while (decimals > 0 && digits % 10 == 0)
        {
            digits /= 10;
            decimals--;
        }

        if (value < 0)
        {
            target.Append('-');
        }

        string text = digits.ToString(CultureInfo.InvariantCulture).PadLeft(decimals + 1, '0');
        target.Append(text, 0, text.Length - decimals);
        if (decimals > 0)
        {
            target.Append('.').Append(text, text.Length - decimals, decimals);
        }
    }

    /// <summary>A number as text: see <see cref="Append"/>.</summary>
    public static string Format(double value, int decimals)
    {
        var text = new StringBuilder();
        Append(text, value, decimals);
        return text.ToString();
    }
}
