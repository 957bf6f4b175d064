using System;
using System.Linq;

namespace Harvester.Evaluation.Reports;

/// <summary>A setting of a drive for a reader: drive.json has lookAheadMetres: 10, the page has "look ahead: 10 m".</summary>
internal static class SettingLabel
{
    private static readonly (string Suffix, string Unit)[] Units = [("Metres", " m"), ("Seconds", " s")];

    /// <summary>Its name in words, and its value with the unit that the key names.</summary>
    public static (string Name, string Value) Of(string key, string value)
    {
        (string suffix, string unit) = Units.FirstOrDefault(
            each => key.EndsWith(each.Suffix, StringComparison.Ordinal), (Suffix: "", Unit: ""));
        return (Words(key[..^suffix.Length]), value + unit);
    }

    private static string Words(string key) =>
        string.Concat(key.Select(letter => char.IsAsciiLetterUpper(letter) ? $" {char.ToLowerInvariant(letter)}" : letter.ToString()));
}
