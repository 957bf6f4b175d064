using System;
using System.Collections.Generic;

namespace Harvester.Geometry.PixelMaps;

/// <summary>A target together with the pixels of its cuboid's silhouette and what is known of how much of it shows.</summary>
internal sealed class TargetView
{
    /// <summary>From this many visible pixels on, an error counts by its share of them; smaller objects may be rougher.</summary>
    private const int SmallPixels = 230;

    /// <summary>How much rougher a small object may be, and the visible pixels below which only being found matters.</summary>
    private const double SmallAllowance = 3;
    private const double TinyPixels = 400;

    private const int Seeds = 2;

    public TargetView(MapTarget target, SilhouetteSpans spans)
    {
        Target = target;
        Spans = spans;
    }

    public MapTarget Target { get; }

    public SilhouetteSpans Spans { get; }

    /// <summary>The visible pixels of which errors are counted as shares: more than there are for small objects.</summary>
    public double CountedPixels { get; private set; } = 1;

    /// <summary>What one wrong pixel counts.</summary>
    public double Weight => 1 / CountedPixels;

    /// <summary>The first pixels to ask: the middle of the silhouette and a few spread over it.</summary>
    public IEnumerable<Place> SeedSamples()
    {
        for (int i = 0; i <= Seeds; i++)
        {
            if (SpreadPixel(i) is { } pixel)
            {
                yield return Place.OfPixel(pixel.Column, pixel.Row);
            }
        }
    }

    /// <summary>A pixel of the silhouette: number 0 in its middle row, the others spread evenly. Null where the row has none.</summary>
    public (int Column, int Row)? SpreadPixel(int number)
    {
        int row = Spans.FirstRow + (int)((Spans.LastRow - Spans.FirstRow + 1) * Fraction(0.5 + (number * R2Sequence.First)));
        (int first, int last) = Spans.Row(row);
        return first <= last ? (first + (int)((last - first + 1) * Fraction(0.5 + (number * R2Sequence.Second))), row) : null;
    }

    /// <summary>Estimates the visible pixels from the share of the rays through the silhouette that met the object.</summary>
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

        // A third of a ray is added for what no ray happened to meet.
        SetVisible(Spans.PixelCount * (met + 0.3) / (asked + 1));
    }

    public void SetVisible(double pixels) =>
        CountedPixels = pixels >= SmallPixels ? pixels : Math.Max(TinyPixels, SmallAllowance * pixels);

    private static double Fraction(double value) => value - Math.Floor(value);
}
