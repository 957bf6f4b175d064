using System;
using System.Globalization;

namespace Harvester.Driving.Bridge;

/// <summary>Words of a client's as they may be repeated in a line of ours: they may be long, and of several lines.</summary>
internal static class ClientText
{
    private const int MaxLetters = 40;

    /// <summary>The beginning of a text in quotes, with a question mark for each letter that does not print.</summary>
    public static string Quoted(string text)
    {
        string beginning = text.Length > MaxLetters ? text.Substring(0, MaxLetters) : text;
        char[] letters = Array.ConvertAll(beginning.ToCharArray(), static letter => IsPrinted(letter) ? letter : '?');
        return text.Length > MaxLetters ? $"'{new string(letters)}...'" : $"'{new string(letters)}'";
    }

    private static bool IsPrinted(char letter) => CharUnicodeInfo.GetUnicodeCategory(letter)
        is not (UnicodeCategory.Control or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator
            or UnicodeCategory.Format or UnicodeCategory.Surrogate or UnicodeCategory.OtherNotAssigned);
}
