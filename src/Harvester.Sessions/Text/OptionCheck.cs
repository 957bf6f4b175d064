using System;

namespace Harvester.Sessions.Text;

/// <summary>The checks of options at the public edge.</summary>
internal static class OptionCheck
{
    public static double AtLeast(double value, double least, string name) =>
        value >= least && !double.IsInfinity(value)
            ? value
            : throw new ArgumentOutOfRangeException(
                name, value, FormattableString.Invariant($"{name} must be a number of at least {least}."));

    public static double Positive(double value, string name) =>
        value > 0 && !double.IsInfinity(value)
            ? value
            : throw new ArgumentOutOfRangeException(name, value, $"{name} must be a number greater than 0.");

    public static double Fraction(double value, string name) =>
        value >= 0 && value <= 1
            ? value
            : throw new ArgumentOutOfRangeException(name, value, $"{name} must be 0 to 1.");

    public static int InRange(int value, int least, int most, string name) =>
        value >= least && value <= most
            ? value
            : throw new ArgumentOutOfRangeException(name, value, FormattableString.Invariant($"{name} must be {least} to {most}."));
}
