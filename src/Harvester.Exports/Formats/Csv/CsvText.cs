namespace Harvester.Exports.Formats.Csv;

/// <summary>
/// Text in tables that people open in spreadsheets. A text that a spreadsheet would take for a formula begins with an apostrophe, as OWASP
/// recommends against CSV injection. Numbers are not changed.
/// </summary>
internal static class CsvText
{
    private const char Quote = '\'';

    /// <summary>A text as written to a table; empty for null.</summary>
    public static string Of(string? text) => text is ['=' or '+' or '-' or '@' or '\t' or '\r' or '\n', ..] ? Quote + text : text ?? "";

    /// <summary>The original text of a field.</summary>
    public static string Read(string field) => field is [Quote, '=' or '+' or '-' or '@' or '\t' or ' ', ..] ? field[1..] : field;
}
