namespace Harvester.Mod.Tests.Guide;

/// <summary>Letters made of straight strokes.</summary>
internal static class StrokeLetters
{
    /// <summary>Row of the baseline; letters such as g reach down to row 0, capitals up to row 6.</summary>
    public const int Rows = 6;

    /// <summary>Distance from one letter to the next, columns.</summary>
    public const int Advance = 3;

    /// <summary>Strokes through points of a grid, column 0 to 2 from the left and row 0 to 6 from below; a bar lifts the pen.</summary>
    private static readonly Dictionary<char, string> Glyphs = new()
    {
        ['A'] = "02 05 16 25 22|04 24",
        ['B'] = "02 06 16 25 14 23 12 02|04 14",
        ['C'] = "26 06 02 22",
        ['D'] = "02 06 16 25 23 12 02",
        ['E'] = "26 06 02 22|04 24",
        ['F'] = "26 06 02|04 14",
        ['G'] = "26 06 02 22 24 14",
        ['H'] = "06 02|26 22|04 24",
        ['I'] = "16 12",
        ['J'] = "26 22 02 03",
        ['K'] = "06 02|26 04 22",
        ['L'] = "06 02 22",
        ['M'] = "02 06 14 26 22",
        ['N'] = "02 06 22 26",
        ['O'] = "02 06 26 22 02",
        ['P'] = "02 06 26 24 04",
        ['Q'] = "02 06 26 22 02|13 22",
        ['R'] = "02 06 26 24 04|14 22",
        ['S'] = "26 06 04 24 22 02",
        ['T'] = "06 26|16 12",
        ['U'] = "06 02 22 26",
        ['V'] = "06 12 26",
        ['W'] = "06 02 14 22 26",
        ['X'] = "06 22|02 26",
        ['Y'] = "06 14 26|14 12",
        ['Z'] = "06 26 02 22",
        ['a'] = "04 24 22 02 03 23",
        ['b'] = "06 02 22 24 04",
        ['c'] = "24 04 02 22",
        ['d'] = "26 22 02 04 24",
        ['e'] = "03 23 24 04 02 22",
        ['f'] = "26 16 12|04 24",
        ['g'] = "22 02 04 24 20 00",
        ['h'] = "06 02|04 24 22",
        ['i'] = "14 12|16 16",
        ['j'] = "14 10 00|16 16",
        ['k'] = "06 02|24 03 22",
        ['l'] = "16 12",
        ['m'] = "02 04 24 22|14 12",
        ['n'] = "02 04 24 22",
        ['o'] = "02 04 24 22 02",
        ['p'] = "00 04 24 22 02",
        ['q'] = "20 24 04 02 22",
        ['r'] = "02 04|03 14 24",
        ['s'] = "24 04 03 23 22 02",
        ['t'] = "16 12 22|04 24",
        ['u'] = "04 02 22 24",
        ['v'] = "04 12 24",
        ['w'] = "04 02 22 24|14 12",
        ['x'] = "04 22|02 24",
        ['y'] = "04 02 22|24 20 00",
        ['z'] = "04 24 02 22",
        ['0'] = "02 06 26 22 02",
        ['1'] = "05 16 12",
        ['2'] = "06 26 24 04 02 22",
        ['3'] = "06 26 22 02|04 24",
        ['4'] = "06 04 24|26 22",
        ['5'] = "26 06 04 24 22 02",
        ['6'] = "26 06 02 22 24 04",
        ['7'] = "06 26 12",
        ['8'] = "02 06 26 22 02|04 24",
        ['9'] = "02 22 26 06 04 24",
        ['.'] = "12 12",
        [','] = "12 01",
        [':'] = "12 12|14 14",
        ['-'] = "04 24",
        ['_'] = "02 22",
        [';'] = "12 01|14 14",
        ['\''] = "16 15",
        ['%'] = "02 26|06 06|22 22",
        ['/'] = "02 26",
        ['\\'] = "06 22",
        ['('] = "26 15 13 22",
        [')'] = "06 15 13 02",
        [' '] = "",
    };

    /// <summary>The strokes of a letter; a letter that is missing here fails.</summary>
    public static IEnumerable<(double X, double Y, double EndX, double EndY)> StrokesOf(char letter)
    {
        foreach (string stroke in Glyphs[letter].Split('|', StringSplitOptions.RemoveEmptyEntries))
        {
            (int X, int Y)[] points = [.. stroke.Split(' ').Select(point => (point[0] - '0', Rows - (point[1] - '0')))];
            for (int i = 1; i < points.Length; i++)
            {
                yield return (points[i - 1].X, points[i - 1].Y, points[i].X, points[i].Y);
            }
        }
    }
}
