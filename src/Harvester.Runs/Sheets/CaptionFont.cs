using System.Globalization;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Models;

namespace Harvester.Runs.Sheets;

/// <summary>Draws captions into an image, in capital letters made of straight strokes.</summary>
public static class CaptionFont
{
    private const int LineStep = 16;
    private const int Unit = 3;
    private const int Advance = 9;
    private const int Margin = 4;

    /// <summary>A crossed box, for a character that the font lacks.</summary>
    private static readonly (int Column, int Row)[][] Unknown =
    [
        [(0, 0), (0, 4), (2, 4), (2, 0), (0, 0), (2, 4)],
    ];

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
        foreach (IReadOnlyList<(int Column, int Row)> stroke in StrokeGlyphs.StrokesOf(letter) ?? Unknown)
        {
            for (int point = 1; point < stroke.Count; point++)
            {
                Draw(target, left, top, stroke[point - 1], stroke[point]);
            }
        }
    }

    private static void Draw(PixelBuffer target, int left, int top, (int Column, int Row) from, (int Column, int Row) to)
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

    private static (int X, int Y) PixelOf((int Column, int Row) point) => (point.Column * Unit, (StrokeGlyphs.Height - point.Row) * Unit);

    private static void Dot(PixelBuffer target, int x, int y)
    {
        const byte ink = 235;
        target.Bytes.AsSpan(((y * target.Size.Width) + x) * PixelBuffer.BytesPerPixel, PixelBuffer.BytesPerPixel).Fill(ink);
    }
}
