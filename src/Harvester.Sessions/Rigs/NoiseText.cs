using System.Globalization;

namespace Harvester.Sessions.Rigs;

/// <summary>Noise as text: a list such as <c>gyro=1.7e-4,accel=2e-3</c>, of which the values that are missing are 0.</summary>
internal static class NoiseText
{
    /// <summary>The values in a text.</summary>
    /// <typeparam name="T">What has the values.</typeparam>
    /// <param name="text">The text.</param>
    /// <param name="ideal">What has no noise.</param>
    /// <param name="withValue">Sets a value by its name; null if there is no such name, or if the value is too great.</param>
    /// <param name="withName">Sets the values for which a name alone stands; null if it stands for none.</param>
    /// <returns>The values; null if the text is no such list.</returns>
    public static T? Parse<T>(string text, T ideal, Func<T, string, double, T?> withValue, Func<T, string, T?> withName)
        where T : class
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        T? noise = ideal;
        foreach (string part in text.Split(','))
        {
            string[] halves = part.Trim().Split(['='], 2);
            noise =
                halves.Length == 1 ? withName(noise, halves[0])
                : Value(halves[1]) is { } value ? withValue(noise, halves[0], value)
                : null;
            if (noise is null)
            {
                return null;
            }
        }

        return noise;
    }

    private static double? Value(string text) =>
        double.TryParse(text, NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent, CultureInfo.InvariantCulture, out double value)
        && value >= 0
            ? value
            : null;
}
