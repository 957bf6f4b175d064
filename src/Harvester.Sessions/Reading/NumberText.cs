using System.Globalization;

namespace Harvester.Sessions.Reading;

/// <summary>Reads numbers that are written as text, in the invariant culture.</summary>
public static class NumberText
{
    /// <summary>A finite number; null if the text is not one.</summary>
    public static double? Read(string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value) ? value : null;

    /// <summary>Finite numbers separated by commas; null if the text is not exactly <paramref name="count"/> of them.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="text"/> is null.</exception>
    public static double[]? ReadList(string text, int count)
    {
        ArgumentNullException.ThrowIfNull(text);
        double?[] numbers = [.. text.Split(',').Select(part => Read(part.Trim()))];
        return numbers.Length == count && numbers.All(number => number is not null) ? [.. numbers.Select(number => number!.Value)] : null;
    }
}
