namespace Harvester.Sessions.Text;

/// <summary>Checks of options in the public API.</summary>
internal static class OptionCheck
{
    public static double AtLeast(double value, double minimum, string name) =>
        value >= minimum && !double.IsInfinity(value)
            ? value
            : throw new ArgumentOutOfRangeException(
                name,
                value,
                FormattableString.Invariant($"{name} must be a number of at least {minimum}.")
            );

    public static double Positive(double value, string name) =>
        value > 0 && !double.IsInfinity(value)
            ? value
            : throw new ArgumentOutOfRangeException(name, value, $"{name} must be a number greater than 0.");

    public static double Fraction(double value, string name) =>
        value >= 0 && value <= 1 ? value : throw new ArgumentOutOfRangeException(name, value, $"{name} must be 0 to 1.");

    public static int InRange(int value, int minimum, int maximum, string name) =>
        value >= minimum && value <= maximum
            ? value
            : throw new ArgumentOutOfRangeException(name, value, FormattableString.Invariant($"{name} must be {minimum} to {maximum}."));
}
