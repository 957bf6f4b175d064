using System.Globalization;

namespace Harvester.Driving.Bridge;

/// <summary>Makes text of a client safe to repeat in a message of one line: it may be long and have several lines.</summary>
internal static class ClientText
{
    private const int MaxLetters = 40;

    /// <summary>The beginning of a text in quotation marks, with a question mark for each unprintable character.</summary>
    public static string Quoted(string text)
    {
        string beginning = text.Length > MaxLetters ? text.Substring(0, MaxLetters) : text;
        char[] letters = Array.ConvertAll(beginning.ToCharArray(), static letter => IsPrinted(letter) ? letter : '?');
        return text.Length > MaxLetters ? $"'{new string(letters)}...'" : $"'{new string(letters)}'";
    }

    private static bool IsPrinted(char letter) =>
        CharUnicodeInfo.GetUnicodeCategory(letter)
            is not (
                UnicodeCategory.Control
                or UnicodeCategory.LineSeparator
                or UnicodeCategory.ParagraphSeparator
                or UnicodeCategory.Format
                or UnicodeCategory.Surrogate
                or UnicodeCategory.OtherNotAssigned
            );
}
