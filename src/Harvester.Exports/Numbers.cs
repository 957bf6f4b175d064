using System.Globalization;
using Harvester.Sessions.Text;

namespace Harvester.Exports;

/// <summary>Formats and parses numbers in text files of datasets.</summary>
internal static class Numbers
{
    /// <summary>An integer.</summary>
    public static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);

    /// <summary>Numbers rounded to a number of decimals, separated by blanks.</summary>
    public static string Row(int decimals, params ReadOnlySpan<double> values)
    {
        string[] texts = new string[values.Length];
        for (int i = 0; i < values.Length; i++)
        {
            texts[i] = InvariantNumber.Format(values[i], decimals);
        }

        return string.Join(' ', texts);
    }

    /// <summary>A number as a reader of the file gets it.</summary>
    public static double Rounded(int decimals, double value) =>
        double.Parse(InvariantNumber.Format(value, decimals), CultureInfo.InvariantCulture);

    /// <summary>Parses words as finite numbers; null if one is not.</summary>
    public static double[]? Parse(IEnumerable<string> words)
    {
        var numbers = new List<double>();
        foreach (string word in words)
        {
            if (!double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) || !double.IsFinite(number))
            {
                return null;
            }

            numbers.Add(number);
        }

        return [.. numbers];
    }
}
