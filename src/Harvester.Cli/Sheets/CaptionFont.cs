using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Harvester.Sessions.Imaging;

namespace Harvester.Cli.Sheets;

/// <summary>Draws captions into an image, in capital letters made of straight strokes.</summary>
internal static class CaptionFont
{
    private const int LineStep = 16;
    private const int Unit = 3;
    private const int Rows = 4;
    private const int Advance = 9;
    private const int Margin = 4;

    /// <summary>
    /// Strokes through points of a grid, column 0 to 2 from the left and row 0 to 4 from the bottom; a bar lifts the pen.
    /// </summary>
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
        ['0'] = "00 04 24 20 00|11 13",
        ['1'] = "03 14 10",
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
        [' '] = "",
    };

    private const string Unknown = "00 04 24 20 00 24";

    /// <summary>Height of a caption with its margins, pixels.</summary>
    public static int HeightOf(int lines) => (lines * LineStep) + Margin;

    /// <summary>The lines of a caption: it is broken between words, and within a word that is longer than a line.</summary>
    /// <param name="text">The caption.</param>
    /// <param name="width">Width of the room, pixels; a line has at least one letter.</param>
    public static IReadOnlyList<string> LinesOf(string text, int width)
    {
        int fitting = Math.Max(1, (width - (2 * Margin)) / Advance);
        List<string> lines = [];
        string line = "";
        foreach (string[] word in text.Split(' ').Select(word => word.Chunk(fitting).Select(part => new string(part)).ToArray()))
        {
            foreach (string part in word.DefaultIfEmpty(""))
            {
                if (line.Length > 0 && line.Length + 1 + part.Length > fitting)
                {
                    lines.Add(line.TrimEnd());
                    line = part;
                }
                else
                {
                    line = line.Length > 0 ? $"{line} {part}" : part;
                }
            }
        }

        lines.Add(line);
        return lines;
    }

    /// <summary>Writes a caption.</summary>
    /// <param name="target">The image, with room for the lines of the caption.</param>
    /// <param name="text">The caption; letters are capitalised, characters that the font lacks are drawn as a crossed box.</param>
    /// <param name="left">Left edge of the room, pixels.</param>
    /// <param name="top">Its top edge, pixels.</param>
    /// <param name="width">Its width, pixels.</param>
    public static void Write(PixelBuffer target, string text, int left, int top, int width)
    {
        foreach ((int number, string line) in LinesOf(text.ToUpper(CultureInfo.InvariantCulture), width).Index())
        {
            for (int i = 0; i < line.Length; i++)
            {
                Write(target, line[i], left + Margin + (i * Advance), top + Margin + (number * LineStep));
            }
        }
    }

    private static void Write(PixelBuffer target, char letter, int left, int top)
    {
        foreach (string stroke in Glyphs.GetValueOrDefault(letter, Unknown).Split('|', StringSplitOptions.RemoveEmptyEntries))
        {
            string[] points = stroke.Split(' ');
            for (int point = 1; point < points.Length; point++)
            {
                Draw(target, left, top, points[point - 1], points[point]);
            }
        }
    }

    private static void Draw(PixelBuffer target, int left, int top, string from, string to)
    {
        (int x, int y) = PixelOf(from);
        (int endX, int endY) = PixelOf(to);
        int steps = Math.Max(1, Math.Max(Math.Abs(endX - x), Math.Abs(endY - y)));
        for (int i = 0; i <= steps; i++)
        {
            double along = (double)i / steps;
            Dot(target, left + x + (int)Math.Round((endX - x) * along), top + y + (int)Math.Round((endY - y) * along));
        }
    }

    private static (int X, int Y) PixelOf(string point) => ((point[0] - '0') * Unit, (Rows - (point[1] - '0')) * Unit);

    private static void Dot(PixelBuffer target, int x, int y)
    {
        const byte ink = 235;
        target.Bytes.AsSpan(((y * target.Size.Width) + x) * PixelBuffer.BytesPerPixel, PixelBuffer.BytesPerPixel).Fill(ink);
    }
}
