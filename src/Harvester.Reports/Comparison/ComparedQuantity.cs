namespace Harvester.Reports.Comparison;

/// <summary>A quantity whose distributions are compared.</summary>
/// <param name="Key">Name in JSON.</param>
/// <param name="Title">Name in tables.</param>
/// <param name="Unit">Its unit; empty for counts and fractions.</param>
/// <param name="Range">Its whole range, if it is bounded.</param>
public sealed record ComparedQuantity(string Key, string Title, string Unit, (double Min, double Max)? Range = null)
{
    private const int Bins = 36;

    /// <summary>Beyond this quantile, the numbers of an unbounded quantity share the last bin.</summary>
    private const double LastBinFrom = 0.95;

    private const double HalfTurn = 180;
    private const double White = 255;

    /// <summary>Height of the 2D box, pixels.</summary>
    public static ComparedQuantity BoxHeight { get; } = new("boxHeight", "2D box height", "px");

    /// <summary>Width of the 2D box, pixels.</summary>
    public static ComparedQuantity BoxWidth { get; } = new("boxWidth", "2D box width", "px");

    /// <summary>Area of the 2D box, square pixels.</summary>
    public static ComparedQuantity BoxArea { get; } = new("boxArea", "2D box area", "px²");

    /// <summary>Distance from the camera to the centre of the object, metres.</summary>
    public static ComparedQuantity Distance { get; } = new("distance", "Distance", "m");

    /// <summary>Fraction outside the image.</summary>
    public static ComparedQuantity Truncation { get; } = new("truncation", "Truncation", "", (0, 1));

    /// <summary>Fraction hidden by something nearer.</summary>
    public static ComparedQuantity Occlusion { get; } = new("occlusion", "Occlusion", "", (0, 1));

    /// <summary>KITTI's observation angle, degrees.</summary>
    public static ComparedQuantity Orientation { get; } = new("orientation", "Observation angle", "°", (-HalfTurn, HalfTurn));

    /// <summary>Objects per frame.</summary>
    public static ComparedQuantity ObjectsPerFrame { get; } = new("objectsPerFrame", "Objects per frame", "");

    /// <summary>Mean brightness of an image, 0 to 255.</summary>
    public static ComparedQuantity Brightness { get; } = new("brightness", "Image brightness", "of 255", (0, White));

    /// <summary>All, in the order of the page.</summary>
    public static IReadOnlyList<ComparedQuantity> All { get; } =
    [BoxHeight, BoxWidth, BoxArea, Distance, Truncation, Occlusion, Orientation, ObjectsPerFrame, Brightness];

    /// <summary>The 1-Wasserstein distance of two distributions of this quantity, in its unit; null if one is empty.</summary>
    public double? Between(ValueSketch first, ValueSketch second) =>
        this == Orientation
            ? DistributionDistance.WassersteinOnCircle(first, second, 2 * HalfTurn)
            : DistributionDistance.Wasserstein(first, second);

    /// <summary>Ends of the bins of a histogram that shows two distributions; an unbounded quantity has an open last bin.</summary>
    public double[] Edges(ValueSketch first, ValueSketch second)
    {
        ArgumentNullException.ThrowIfNull(first);
        ArgumentNullException.ThrowIfNull(second);
        double min = Range?.Min ?? 0;
        double max = Range?.Max ?? Math.Max(first.Quantile(LastBinFrom) ?? 0, second.Quantile(LastBinFrom) ?? 0);
        double step = max > min ? (max - min) / Bins : 1;
        if (this == ObjectsPerFrame)
        {
            step = Math.Ceiling(step);
        }

        return [.. Enumerable.Range(0, Bins + 1).Select(bin => min + (bin * step))];
    }
}
