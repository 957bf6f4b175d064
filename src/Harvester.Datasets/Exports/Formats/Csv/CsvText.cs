namespace Harvester.Datasets.Exports.Formats.Csv;

/// <summary>
/// Texts in tables that people open in spreadsheets: one that a spreadsheet would take for a formula begins with an apostrophe, as OWASP
/// advises against CSV injection. Numbers are no texts and stay numbers.
/// </summary>
internal static class CsvText
{
    private const char Quote = '\'';

    /// <summary>How a text stands in a table; nothing for null.</summary>
    public static string Of(string? text) => text is ['=' or '+' or '-' or '@' or '\t' or '\r' or '\n', ..] ? Quote + text : text ?? "";

    /// <summary>The text that stands in a table.</summary>
    public static string Read(string field) => field is [Quote, '=' or '+' or '-' or '@' or '\t' or ' ', ..] ? field[1..] : field;
}
