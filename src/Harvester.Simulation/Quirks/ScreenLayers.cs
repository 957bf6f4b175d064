using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Quirks;

/// <summary>What lies over the picture of the world, and what the computer does to the picture before it is grabbed.</summary>
/// <param name="quirks">The faults.</param>
internal sealed class ScreenLayers(GameQuirks quirks)
{
    /// <summary>Where the radar and the foreign display are, fractions of the window, and how large their squares are, pixels.</summary>
    private static readonly Box2D Radar = new(0.02, 0.74, 0.2, 0.97);
    private static readonly Box2D Counter = new(0.9, 0.02, 0.99, 0.07);
    private const int SquarePixels = 6;

    /// <summary>The part of the picture whose level of detail changes, fractions, and by how many grey levels.</summary>
    private static readonly Box2D Detail = new(0.4, 0.5, 0.6, 0.65);
    private const int DetailLevels = 40;

    /// <summary>The colour of another window.</summary>
    private const byte OtherWindowLevel = 240;

    /// <summary>Whether the game has a head-up display.</summary>
    public bool HasHud => quirks.ShowsHud;

    /// <summary>Whether the head-up display is asked to be hidden.</summary>
    public bool IsHudHidden { get; set; }

    /// <summary>The colours over the picture.</summary>
    public IReadOnlyList<ColourPatch> Card { get; set; } = [];

    /// <summary>Draws what lies over a picture, then changes the picture as the computer does.</summary>
    /// <param name="picture">The picture of the world.</param>
    /// <param name="frozenTicks">Number of ticks for which the world has been frozen; 0 while it runs.</param>
    public void Apply(PixelBuffer picture, int frozenTicks)
    {
        if (quirks.DetailChangesAfterTicks > 0 && frozenTicks >= quirks.DetailChangesAfterTicks)
        {
            Fill(picture, Detail, static (_, _, before) => (byte)(before < 128 ? before + DetailLevels : before - DetailLevels));
        }

        if (quirks.ShowsHud && (!IsHudHidden || (quirks.HudStaysWhileFrozen && frozenTicks > 0)))
        {
            Fill(picture, Radar, Chequered);
        }

        if (quirks.ShowsForeignDisplay)
        {
            Fill(picture, Counter, Chequered);
        }

        foreach (ColourPatch patch in Card)
        {
            Fill(
                picture,
                patch.Place,
                (pixel, channel, _) =>
                    channel == 0 ? patch.Red
                    : channel == 1 ? patch.Green
                    : patch.Blue
            );
        }

        Enlarge(picture);
        ChangeTones(picture);
        if (quirks.ShowsOtherWindow)
        {
            Array.Fill(picture.Bytes, OtherWindowLevel);
        }
    }

    private static byte Chequered((int Column, int Row) pixel, int channel, byte before) =>
        ((pixel.Column / SquarePixels) + (pixel.Row / SquarePixels)) % 2 == 0 ? byte.MaxValue : (byte)0;

    private static void Fill(PixelBuffer picture, Box2D place, Func<(int Column, int Row), int, byte, byte> level)
    {
        (int width, int height) = (picture.Size.Width, picture.Size.Height);
        for (int row = (int)Math.Round(place.YMin * height); row < Math.Min(height, (int)Math.Round(place.YMax * height)); row++)
        {
            for (int column = (int)Math.Round(place.XMin * width); column < Math.Min(width, (int)Math.Round(place.XMax * width)); column++)
            {
                for (int channel = 0; channel < PixelBuffer.BytesPerPixel; channel++)
                {
                    int index = (((row * width) + column) * PixelBuffer.BytesPerPixel) + channel;
                    picture.Bytes[index] = level((column, row), channel, picture.Bytes[index]);
                }
            }
        }
    }

    private void Enlarge(PixelBuffer picture)
    {
        if (quirks.WindowScale <= 1)
        {
            return;
        }

        byte[] whole = [.. picture.Bytes];
        int width = picture.Size.Width;
        for (int pixel = 0; pixel < picture.Size.PixelCount; pixel++)
        {
            int source = ((int)(pixel / width / quirks.WindowScale) * width) + (int)(pixel % width / quirks.WindowScale);
            Buffer.BlockCopy(
                whole,
                source * PixelBuffer.BytesPerPixel,
                picture.Bytes,
                pixel * PixelBuffer.BytesPerPixel,
                PixelBuffer.BytesPerPixel
            );
        }
    }

    private void ChangeTones(PixelBuffer picture)
    {
        if (quirks.PictureGain == 1 && quirks.PictureExponent == 1)
        {
            return;
        }

        var tones = new byte[byte.MaxValue + 1];
        for (int level = 0; level < tones.Length; level++)
        {
            double changed = byte.MaxValue * quirks.PictureGain * Math.Pow((double)level / byte.MaxValue, quirks.PictureExponent);
            tones[level] = (byte)Math.Clamp(Math.Round(changed), 0, byte.MaxValue);
        }

        for (int i = 0; i < picture.Bytes.Length; i++)
        {
            picture.Bytes[i] = tones[picture.Bytes[i]];
        }
    }
}
