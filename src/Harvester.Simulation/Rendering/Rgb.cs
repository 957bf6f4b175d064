namespace Harvester.Simulation.Rendering;

/// <summary>A colour as it is stored in pictures (sRGB).</summary>
/// <param name="Red">Red, 0 to 255.</param>
/// <param name="Green">Green, 0 to 255.</param>
/// <param name="Blue">Blue, 0 to 255.</param>
public readonly record struct Rgb(byte Red, byte Green, byte Blue)
{
    /// <summary>The colour with its brightness multiplied, clamped to the range of a byte.</summary>
    public Rgb Scaled(double factor) => new(Scale(Red, factor), Scale(Green, factor), Scale(Blue, factor));

    /// <summary>The colour a fraction of the way to another.</summary>
    public Rgb Towards(Rgb other, double fraction) =>
        new(
            Scale(Red, 1 - fraction, other.Red * fraction),
            Scale(Green, 1 - fraction, other.Green * fraction),
            Scale(Blue, 1 - fraction, other.Blue * fraction)
        );

    private static byte Scale(byte value, double factor, double offset = 0) =>
        (byte)System.Math.Clamp(System.Math.Round((value * factor) + offset), 0, 255);
}
