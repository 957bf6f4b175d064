namespace Harvester.Simulation.Models;

/// <summary>
/// Capital letters, digits and punctuation made of straight strokes, for the faces of signs and for captions. Strokes lead through points
/// of a grid: column 0 to 2 from the left and row 0 to 4 from the bottom.
/// </summary>
public static class StrokeGlyphs
{
    /// <summary>The last row of the grid: the height of a letter.</summary>
    public const int Height = 4;

    /// <summary>The last column of the grid: the width of a letter.</summary>
    public const int Width = 2;

    /// <summary>By letter: points as pairs of digits, column and row; a bar lifts the pen.</summary>
    private static readonly Dictionary<char, string> Glyphs = new()
    {
        ['A'] = "00 03 14 23 20|02 22",
        ['B'] = "00 04 14 23 12 21 10 00|02 12",
        ['C'] = "24 04 00 20",
        ['D'] = "00 04 14 23 21 10 00",
        ['E'] = "24 04 00 20|02 22",
        ['F'] = "24 04 00|02 12",
        ['G'] = "24 04 00 20 22 12",
        ['H'] = "04 00|24 20|02 22",
        ['I'] = "14 10",
        ['J'] = "24 20 00 01",
        ['K'] = "04 00|24 02 20",
        ['L'] = "04 00 20",
        ['M'] = "00 04 12 24 20",
        ['N'] = "00 04 20 24",
        ['O'] = "00 04 24 20 00",
        ['P'] = "00 04 24 22 02",
        ['Q'] = "00 04 24 20 00|11 20",
        ['R'] = "00 04 24 22 02|12 20",
        ['S'] = "24 04 02 22 20 00",
        ['T'] = "04 24|14 10",
        ['U'] = "04 00 20 24",
        ['V'] = "04 10 24",
        ['W'] = "04 00 12 20 24",
        ['X'] = "04 20|00 24",
        ['Y'] = "04 12 24|12 10",
        ['Z'] = "04 24 00 20",
        ['0'] = "00 04 24 20 00",
        ['1'] = "14 10",
        ['2'] = "04 24 22 02 00 20",
        ['3'] = "04 24 20 00|02 22",
        ['4'] = "04 02 22|24 20",
        ['5'] = "24 04 02 22 20 00",
        ['6'] = "24 04 00 20 22 02",
        ['7'] = "04 24 10",
        ['8'] = "00 04 24 20 00|02 22",
        ['9'] = "00 20 24 04 02 22",
        [','] = "11 00",
        ['.'] = "10 10",
        [':'] = "11 11|13 13",
        ['-'] = "02 22",
        ['+'] = "02 22|11 13",
        ['/'] = "00 24",
        ['('] = "24 13 11 20",
        [')'] = "04 13 11 00",
        ['\''] = "14 13",
    };

    /// <summary>The strokes of a letter, each of two points or more; none for a blank, null for a letter that the font lacks.</summary>
    /// <param name="letter">A capital letter, a digit, a punctuation mark or a blank.</param>
    public static IReadOnlyList<IReadOnlyList<(int Column, int Row)>>? StrokesOf(char letter) =>
        letter == ' ' ? []
        : Glyphs.TryGetValue(letter, out string? glyph) ? [.. glyph.Split('|').Select(PointsOf)]
        : null;

    private static IReadOnlyList<(int Column, int Row)> PointsOf(string stroke) =>
        [.. stroke.Split(' ').Select(point => (point[0] - '0', point[1] - '0'))];
}
