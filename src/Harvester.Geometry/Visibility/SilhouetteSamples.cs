using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.Visibility;

/// <summary>
/// Centres of pixels spread evenly over the silhouette of a cuboid in the image, each once: those at the points of the R2 sequence, whose
/// steps are the inverse powers of the plastic number. A part that covers no pixel's centre is not visible in the image.
/// </summary>
internal static class SilhouetteSamples
{
    /// <summary>The root of x³ = x + 1 (Roberts, The unreasonable effectiveness of quasirandom sequences, 2018).</summary>
    private const double PlasticNumber = 1.32471795724474602596;

    /// <summary>Number of points of the sequence tried for each sample wanted, before a thin silhouette is given up.</summary>
    private const int TriesPerSample = 16;

    /// <summary>Up to a number of pixel centres on the silhouette; a greater number begins with those of a smaller one.</summary>
    /// <param name="projection">The cuboid's projection.</param>
    /// <param name="box">The box around its part in the image.</param>
    /// <param name="count">Number of centres wanted; fewer are found if the silhouette has fewer.</param>
    public static IEnumerable<Vector2D> Of(CuboidProjection projection, Box2D box, int count)
    {
        const double stepX = 1 / PlasticNumber;
        const double stepY = 1 / (PlasticNumber * PlasticNumber);
        double pixels = (Math.Ceiling(box.XMax) - Math.Floor(box.XMin)) * (Math.Ceiling(box.YMax) - Math.Floor(box.YMin));
        var tried = new HashSet<(double X, double Y)>();
        int found = 0;
        for (int i = 1; i <= count * TriesPerSample && found < count && tried.Count < pixels; i++)
        {
            // Point i of the sequence, ½ + i·step modulo 1, scaled to the box and moved to the centre of its pixel.
            double x = Math.Floor(box.XMin + (box.Width * Fraction(0.5 + (i * stepX)))) + 0.5;
            double y = Math.Floor(box.YMin + (box.Height * Fraction(0.5 + (i * stepY)))) + 0.5;
            var centre = new Vector2D(x, y);
            if (tried.Add((x, y)) && ConvexPolygon.Contains(projection.Silhouette, centre))
            {
                found++;
                yield return centre;
            }
        }
    }

    /// <summary>Area of the part of a silhouette inside the image, square pixels.</summary>
    public static double AreaOf(CuboidProjection projection) =>
        ConvexPolygon.Area(projection.Silhouette) * (1 - projection.TruncatedFraction);

    private static double Fraction(double value) => value - Math.Floor(value);
}
