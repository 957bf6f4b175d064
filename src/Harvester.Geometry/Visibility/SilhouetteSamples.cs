using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.Visibility;

/// <summary>
/// Centres of pixels spread evenly over the silhouette of a cuboid in the image, each once: those at the points whose columns are multiples
/// of the golden ratio and whose rows are those of van der Corput. A part that covers no pixel's centre is not visible in the image.
/// </summary>
internal static class SilhouetteSamples
{
    /// <summary>
    /// The golden ratio less 1. Of all steps its multiples leave the smallest gaps (Sós, On the distribution mod 1 of the sequence nα,
    /// 1958): what hides objects in streets are upright things, and what shows between them are upright slits.
    /// </summary>
    private const double StepX = 0.61803398874989484820;

    /// <summary>Number of points of the sequence tried for each sample wanted, before a thin silhouette is given up.</summary>
    private const int TriesPerSample = 16;

    /// <summary>Up to a number of pixel centres on the silhouette; a greater number begins with those of a smaller one.</summary>
    /// <param name="projection">The cuboid's projection.</param>
    /// <param name="box">The box around its part in the image.</param>
    /// <param name="count">Number of centres wanted; fewer are found if the silhouette has fewer.</param>
    public static IEnumerable<Vector2D> Of(CuboidProjection projection, Box2D box, int count)
    {
        double pixels = (Math.Ceiling(box.XMax) - Math.Floor(box.XMin)) * (Math.Ceiling(box.YMax) - Math.Floor(box.YMin));
        var tried = new HashSet<(double X, double Y)>();
        int found = 0;
        for (int i = 1; i <= count * TriesPerSample && found < count && tried.Count < pixels; i++)
        {
            // Point i of the sequence, ½ + i·step modulo 1 and i mirrored at the point, scaled to the box and moved to its pixel's centre.
            double x = Math.Floor(box.XMin + (box.Width * Fraction(0.5 + (i * StepX)))) + 0.5;
            double y = Math.Floor(box.YMin + (box.Height * Mirrored(i))) + 0.5;
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

    /// <summary>The binary digits of a number mirrored at the point: 6 = 110 gives 0.011 = 3/8.</summary>
    private static double Mirrored(int number)
    {
        double value = 0;
        for (double digit = 0.5; number > 0; digit /= 2)
        {
            value += (number & 1) * digit;
            number >>= 1;
        }

        return value;
    }
}
