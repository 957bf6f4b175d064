using Harvester.Geometry.Cameras;
using Harvester.Mod.Tests.Games;
using Harvester.Play.Features;
using Harvester.Sessions.Imaging;

namespace Harvester.Mod.Tests.Guide;

/// <summary>A picture of the simulated game's window with what the mod shows over it, at the places that the mod gives.</summary>
internal sealed class GuidePicture
{
    private const double Unit = 2;
    private const double LineStep = 20;
    private const double StrokePixels = 1.3;
    private const int LettersOfALine = 58;
    private static readonly Colour White = new(255, 255, 255);
    private static readonly Colour Black = new(0, 0, 0);

    public GuidePicture(ImageSize size) => Pixels = new PixelBuffer(size);

    /// <summary>The game's picture, over which the rest is drawn.</summary>
    public PixelBuffer Pixels { get; }

    /// <summary>Fills a rectangle; pixels that it covers in part are mixed.</summary>
    public void Fill(DrawnRectangle rectangle) =>
        Cover(
            rectangle.Place.XMin * Width,
            rectangle.Place.YMin * Height,
            rectangle.Place.XMax * Width,
            rectangle.Place.YMax * Height,
            rectangle.Colour,
            1
        );

    /// <summary>Writes a line of the mod's own: white with a dark border.</summary>
    public void Write(DrawnText line)
    {
        Write(line.Text, line.Left * Width, line.Top * Height, Black, 3 * StrokePixels);
        Write(line.Text, line.Left * Width, line.Top * Height, White, StrokePixels);
    }

    /// <summary>Writes a message as the game shows it, in a dark field at the lower left.</summary>
    public void Tell(string message)
    {
        const double left = 20,
            margin = 10,
            bottom = 60;
        string[] lines = [.. Wrapped(message)];
        double top = Height - bottom - (lines.Length * LineStep);
        Cover(left, top - margin, left + (LettersOfALine * StrokeLetters.Advance * Unit) + (2 * margin), Height - bottom, Black, 0.75);
        for (int i = 0; i < lines.Length; i++)
        {
            Write(lines[i], left + margin, top + (i * LineStep), White, StrokePixels);
        }
    }

    /// <summary>Says at the lower edge where the picture comes from.</summary>
    public void Label(string text)
    {
        const double band = 26;
        Cover(0, Height - band, Width, Height, White, 0.9);
        Write(text, 8, Height - band + 6, Black, StrokePixels);
    }

    private int Width => Pixels.Size.Width;

    private int Height => Pixels.Size.Height;

    private static IEnumerable<string> Wrapped(string message)
    {
        string line = string.Empty;
        foreach (string word in message.Split(' '))
        {
            if (line.Length + word.Length >= LettersOfALine)
            {
                yield return line;
                line = string.Empty;
            }

            line = line.Length > 0 ? $"{line} {word}" : word;
        }

        yield return line;
    }

    private void Write(string text, double left, double top, Colour colour, double width)
    {
        foreach ((int place, char letter) in text.Index())
        {
            double x = left + (place * StrokeLetters.Advance * Unit);
            foreach ((double startX, double startY, double endX, double endY) in StrokeLetters.StrokesOf(letter))
            {
                Stroke(x + (startX * Unit), top + (startY * Unit), x + (endX * Unit), top + (endY * Unit), colour, width);
            }
        }
    }

    private void Stroke(double x, double y, double endX, double endY, Colour colour, double width)
    {
        double reach = (width / 2) + 1;
        double lengthSquared = ((endX - x) * (endX - x)) + ((endY - y) * (endY - y));
        for (int row = (int)(Math.Min(y, endY) - reach); row <= Math.Max(y, endY) + reach; row++)
        {
            for (int column = (int)(Math.Min(x, endX) - reach); column <= Math.Max(x, endX) + reach; column++)
            {
                double along =
                    lengthSquared == 0 ? 0 : Math.Clamp((((column - x) * (endX - x)) + ((row - y) * (endY - y))) / lengthSquared, 0, 1);
                double distance = double.Hypot(column - x - (along * (endX - x)), row - y - (along * (endY - y)));
                Mix(column, row, colour, Math.Clamp((width / 2) + 0.5 - distance, 0, 1));
            }
        }
    }

    private void Cover(double left, double top, double right, double bottom, Colour colour, double opacity)
    {
        for (int row = (int)Math.Floor(top); row < bottom; row++)
        {
            double high = Math.Min(bottom, row + 1) - Math.Max(top, row);
            for (int column = (int)Math.Floor(left); column < right; column++)
            {
                Mix(column, row, colour, opacity * high * (Math.Min(right, column + 1) - Math.Max(left, column)));
            }
        }
    }

    private void Mix(int column, int row, Colour colour, double share)
    {
        if (column < 0 || row < 0 || column >= Width || row >= Height || share <= 0)
        {
            return;
        }

        Span<byte> pixel = Pixels.Bytes.AsSpan(((row * Width) + column) * PixelBuffer.BytesPerPixel, PixelBuffer.BytesPerPixel);
        int[] channels = [colour.Red, colour.Green, colour.Blue];
        for (int i = 0; i < channels.Length; i++)
        {
            pixel[i] = (byte)Math.Round(pixel[i] + ((channels[i] - pixel[i]) * share));
        }
    }
}
