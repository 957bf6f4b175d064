using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A row of the image while it is coloured. Eight pixels are worked on at a time, from the left, so that what is written past the end of a
/// stretch is overwritten by the next one; every array has room for that.
/// </summary>
internal sealed class PixelRow
{
    /// <summary>Pixels that are coloured at once.</summary>
    public const int Step = 8;

    private const int Channels = 3;
    private readonly int _width;
    private readonly int[] _colours;

    public PixelRow(int width)
    {
        _width = width;
        int length = width + Step;
        (Across, Down, Stretch) = (new float[length], new float[length], new float[length]);
        (Depths, Through) = (new float[length], new float[length]);
        _colours = new int[length];
    }

    /// <summary>The row's number, from the top.</summary>
    public int Number { get; set; }

    /// <summary>Metres to the right that each pixel looks for a metre ahead.</summary>
    public float[] Across { get; }

    /// <summary>Metres down that each pixel looks for a metre ahead.</summary>
    public float[] Down { get; }

    /// <summary>Length of each pixel's ray per metre of depth.</summary>
    public float[] Stretch { get; }

    /// <summary>Depth of each pixel along the camera's forward axis, metres; infinity for the sky.</summary>
    public float[] Depths { get; }

    /// <summary>The share of the light that the air lets through.</summary>
    public float[] Through { get; }

    /// <summary>Sets the colours of eight pixels.</summary>
    /// <param name="column">The first of them.</param>
    /// <param name="light">Colours, 0 to 1; other values are clamped.</param>
    public void Write(int column, in WideVector light)
    {
        Vector256<int> packed = Channel(light.X) | (Channel(light.Y) << 8) | (Channel(light.Z) << 16);
        packed.CopyTo(_colours, column);
    }

    /// <summary>Copies the row's colours to a picture: red, green and blue of each pixel.</summary>
    public void CopyTo(Span<byte> colours)
    {
        Vector128<byte> order = Vector128.Create((byte)0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255);
        int column = 0;

        // Sixteen bytes are written for every twelve; the next ones overwrite the rest.
        for (; (column * Channels) + Vector128<byte>.Count <= colours.Length; column += 4)
        {
            Vector128<byte> packed = Vector128.Create(_colours, column).AsByte();
            Vector128.Shuffle(packed, order).CopyTo(colours.Slice(column * Channels, Vector128<byte>.Count));
        }

        for (; column < _width; column++)
        {
            Span<byte> pixel = colours.Slice(column * Channels, Channels);
            int packed = _colours[column];
            (pixel[0], pixel[1], pixel[2]) = ((byte)packed, (byte)(packed >> 8), (byte)(packed >> 16));
        }
    }

    private static Vector256<int> Channel(Vector256<float> light) =>
        Vector256.ConvertToInt32Native((Wide.Fraction(light) * Vector256.Create(255f)) + Vector256.Create(0.5f));
}
