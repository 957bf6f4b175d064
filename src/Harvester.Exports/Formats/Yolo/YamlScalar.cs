namespace Harvester.Exports.Formats.Yolo;

/// <summary>Writes strings as YAML scalars.</summary>
internal static class YamlScalar
{
    // Words that YAML 1.1, as PyYAML implements it, or YAML 1.2 read as booleans or null.
    private static readonly string[] Reserved = ["null", "true", "false", "yes", "no", "on", "off", "y", "n"];

    /// <summary>A string as a scalar of the type string: plain where that is safe, otherwise in single quotes.</summary>
    /// <param name="text">One line of text.</param>
    public static string Of(string text) => IsPlain(text) ? text : $"'{text.Replace("'", "''", StringComparison.Ordinal)}'";

    // Numbers and dates begin with a digit or a sign, indicators of the syntax with a punctuation character.
    private static bool IsPlain(string text) =>
        text.Length > 0
        && char.IsAsciiLetter(text[0])
        && text[^1] != ' '
        && text.All(c => char.IsAsciiLetterOrDigit(c) || c is ' ' or '-' or '_')
        && !Reserved.Contains(text, StringComparer.OrdinalIgnoreCase);
}
