namespace Harvester.Capture.Windows;

/// <summary>What a window shows: a colour for each pixel of its client area.</summary>
/// <param name="Red">Red of column x, row y.</param>
/// <param name="Green">Green.</param>
/// <param name="Blue">Blue.</param>
internal sealed record Pattern(Func<int, int, byte> Red, Func<int, int, byte> Green, Func<int, int, byte> Blue)
{
    /// <summary>A pattern in which a shift by a pixel, a swap of channels or of rows changes nearly every byte.</summary>
    public static Pattern Distinct(int seed) =>
        new(
            (x, y) => (byte)((x * 7) + (y * 3) + seed),
            (x, y) => (byte)((x * 5) + (y * 11) + (2 * seed)),
            (x, y) => (byte)((x * y) + x + (3 * seed))
        );

    public static Pattern Uniform(byte red, byte green, byte blue) => new((_, _) => red, (_, _) => green, (_, _) => blue);

    /// <summary>Black except for one pixel that is hardly brighter: a night.</summary>
    public static Pattern Night(int litX, int litY) => new((x, y) => (byte)(x == litX && y == litY ? 1 : 0), (_, _) => 0, (_, _) => 0);

    public byte Channel(int channel, int x, int y) =>
        channel switch
        {
            0 => Red(x, y),
            1 => Green(x, y),
            _ => Blue(x, y),
        };
}
