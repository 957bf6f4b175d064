using Harvester.Simulation.Models;

namespace Harvester.Mod.Tests.Guide;

/// <summary>
/// Letters made of straight strokes: those of <see cref="StrokeGlyphs"/>, and small ones, which reach below the baseline.
/// </summary>
internal static class StrokeLetters
{
    /// <summary>Row of the top of capitals; letters such as g reach down to row 0.</summary>
    public const int Rows = 6;

    /// <summary>Distance from one letter to the next, columns.</summary>
    public const int Advance = 3;

    /// <summary>Row of the baseline, on which the letters of <see cref="StrokeGlyphs"/> stand.</summary>
    private const int Baseline = Rows - StrokeGlyphs.Height;

    /// <summary>
    /// Letters of this font alone. Strokes through points of a grid, column 0 to 2 from the left and row 0 to 6 from below; a bar lifts the
    /// pen.
    /// </summary>
    private static readonly Dictionary<char, string> Glyphs = new()
    {
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
        ['1'] = "05 16 12",
        [','] = "12 01",
        [':'] = "12 12|14 14",
        ['_'] = "02 22",
        [';'] = "12 01|14 14",
        ['%'] = "02 26|06 06|22 22",
        ['\\'] = "06 22",
    };

    /// <summary>The strokes of a letter; a letter that is missing here fails.</summary>
    public static IEnumerable<(double X, double Y, double EndX, double EndY)> StrokesOf(char letter)
    {
        foreach ((int X, int Y)[] points in PointsOf(letter))
        {
            for (int i = 1; i < points.Length; i++)
            {
                yield return (points[i - 1].X, points[i - 1].Y, points[i].X, points[i].Y);
            }
        }
    }

    private static IEnumerable<(int X, int Y)[]> PointsOf(char letter) =>
        !Glyphs.TryGetValue(letter, out string? glyph) && StrokeGlyphs.StrokesOf(letter) is { } strokes
            ? strokes.Select(stroke => stroke.Select(point => (point.Column, Rows - (point.Row + Baseline))).ToArray())
            : (glyph ?? throw new ArgumentException($"The font lacks '{letter}'.", nameof(letter)))
                .Split('|')
                .Select(stroke => stroke.Split(' ').Select(point => (point[0] - '0', Rows - (point[1] - '0'))).ToArray());
}
