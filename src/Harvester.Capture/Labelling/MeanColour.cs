namespace Harvester.Capture.Labelling;

/// <summary>The mean of colours of pixels, as red, green and blue of 0 to 255.</summary>
internal struct MeanColour
{
    private int _count;
    private double _red;
    private double _green;
    private double _blue;

    /// <summary>Adds a pixel.</summary>
    /// <param name="colours">Red, green and blue of all pixels.</param>
    /// <param name="pixel">Its number.</param>
    public void Add(byte[] colours, int pixel)
    {
        _count++;
        _red += colours[pixel * 3];
        _green += colours[(pixel * 3) + 1];
        _blue += colours[(pixel * 3) + 2];
    }

    /// <summary>The squared distance to another mean; both have at least one pixel.</summary>
    public readonly double SquaredTo(in MeanColour other) =>
        Squared(other._red / other._count, other._green / other._count, other._blue / other._count);

    /// <summary>The squared distance to the colour of a pixel.</summary>
    public readonly double SquaredTo(byte[] colours, int pixel) =>
        Squared(colours[pixel * 3], colours[(pixel * 3) + 1], colours[(pixel * 3) + 2]);

    private readonly double Squared(double red, double green, double blue)
    {
        double r = (_red / _count) - red;
        double g = (_green / _count) - green;
        double b = (_blue / _count) - blue;
        return (r * r) + (g * g) + (b * b);
    }
}
