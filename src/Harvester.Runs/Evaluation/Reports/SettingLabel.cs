namespace Harvester.Runs.Evaluation.Reports;

/// <summary>A setting of a drive in words: drive.json has lookAheadMetres: 10, the page has "look ahead: 10 m".</summary>
internal static class SettingLabel
{
    private static readonly (string Suffix, string Unit)[] Units = [("Metres", " m"), ("Seconds", " s")];

    /// <summary>The name in words, and the value with the unit from the key.</summary>
    public static (string Name, string Value) Of(string key, string value)
    {
        (string suffix, string unit) = Units.FirstOrDefault(
            each => key.EndsWith(each.Suffix, StringComparison.Ordinal),
            (Suffix: "", Unit: "")
        );
        return (Words(key[..^suffix.Length]), value + unit);
    }

    private static string Words(string key) =>
        string.Concat(key.Select(letter => char.IsAsciiLetterUpper(letter) ? $" {char.ToLowerInvariant(letter)}" : letter.ToString()));
}
