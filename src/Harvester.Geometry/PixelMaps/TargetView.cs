namespace Harvester.Geometry.PixelMaps;

/// <summary>A target with the pixels of its cuboid's silhouette and an estimate of how many are visible.</summary>
internal sealed class TargetView
{
    /// <summary>
    /// Minimum number of visible pixels from which errors count in proportion to them; smaller objects may be less accurate.
    /// </summary>
    private const int SmallPixels = 230;

    /// <summary>
    /// Factor on the error allowed for a small object, and the number of visible pixels below which it only has to be found.
    /// </summary>
    private const double SmallAllowance = 3;
    private const double TinyPixels = 400;

    private const int Seeds = 2;

    /// <summary>Rays added to those that met the object, for visible parts that no ray happened to hit; one is added to all rays.</summary>
    private const double UnseenHits = 0.3;

    public TargetView(MapTarget target, SilhouetteSpans spans)
    {
        Target = target;
        Spans = spans;
    }

    public MapTarget Target { get; }

    public SilhouetteSpans Spans { get; }

    /// <summary>The number of visible pixels relative to which errors count; for small objects more than there are.</summary>
    public double CountedPixels { get; private set; } = 1;

    /// <summary>The weight of one wrong pixel.</summary>
    public double Weight => 1 / CountedPixels;

    /// <summary>The first pixels to sample: the middle of the silhouette and a few spread over it.</summary>
    public IEnumerable<SubpixelPoint> SeedSamples()
    {
        for (int i = 0; i <= Seeds; i++)
        {
            if (SpreadPixel(i) is { } pixel)
            {
                yield return SubpixelPoint.OfPixel(pixel.Column, pixel.Row);
            }
        }
    }

    /// <summary>A pixel of the silhouette: number 0 in its middle row, the others spread evenly. Null if the row has none.</summary>
    public (int Column, int Row)? SpreadPixel(int number)
    {
        int row = Spans.FirstRow + (int)((Spans.LastRow - Spans.FirstRow + 1) * Fraction(0.5 + (number * R2Sequence.First)));
        (int first, int last) = Spans.Row(row);
        return first <= last ? (first + (int)((last - first + 1) * Fraction(0.5 + (number * R2Sequence.Second))), row) : null;
    }

    /// <summary>Estimates the visible pixels from the fraction of the rays through the silhouette that hit the object.</summary>
    public void EstimateVisible(PixelSamples samples)
    {
        int asked = 0;
        int met = 0;
        for (int row = Spans.FirstRow; row <= Spans.LastRow; row++)
        {
            (int first, int last) = Spans.Row(row);
            for (int column = first; column <= last; column++)
            {
                if (samples.HasDistance(column, row))
                {
                    asked++;
                    met += samples.Number(column, row) == Target.Number ? 1 : 0;
                }
            }
        }

        // The posterior mean of the visible fraction with a prior of one ray, of which 0.3 met the object.
        SetVisible(Spans.PixelCount * (met + UnseenHits) / (asked + 1));
    }

    public void SetVisible(double pixels) => CountedPixels = pixels >= SmallPixels ? pixels : Math.Max(TinyPixels, SmallAllowance * pixels);

    private static double Fraction(double value) => value - Math.Floor(value);
}
