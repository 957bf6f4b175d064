using Harvester.Geometry;

namespace Harvester.Datasets.Boxes;

/// <summary>
/// Points spread evenly over a convex polygon of any size: those of the R2 sequence, whose steps are the inverse powers of the plastic
/// number, mapped to the triangles between the first corner and each side.
/// </summary>
internal static class PolygonSamples
{
    private const double PlasticNumber = 1.32471795724474602596;

    /// <summary>Points within a polygon; none if it has no area.</summary>
    /// <param name="corners">The corners in order.</param>
    /// <param name="count">Number of points.</param>
    public static IEnumerable<Vector2D> Of(IReadOnlyList<Vector2D> corners, int count)
    {
        double[] areas =
        [
            .. Enumerable
                .Range(1, Math.Max(0, corners.Count - 2))
                .Select(i => Math.Abs((corners[i] - corners[0]).Cross(corners[i + 1] - corners[0])) / 2),
        ];
        double total = areas.Sum();
        for (int i = 1; i <= count && total > 0; i++)
        {
            // The first coordinate chooses the triangle by area, and what is left of it a place there.
            double place = total * Fraction(0.5 + (i / PlasticNumber));
            int triangle = 0;
            while (triangle < areas.Length - 1 && place >= areas[triangle])
            {
                place -= areas[triangle++];
            }

            yield return Within(
                corners[0],
                corners[triangle + 1],
                corners[triangle + 2],
                Math.Min(1, place / areas[triangle]),
                Fraction(0.5 + (i / (PlasticNumber * PlasticNumber)))
            );
        }
    }

    // Uniform over the triangle for uniform s and t: (1 - √s) a + √s (1 - t) b + √s t c.
    private static Vector2D Within(Vector2D a, Vector2D b, Vector2D c, double s, double t)
    {
        double root = Math.Sqrt(s);
        return (a * (1 - root)) + (b * (root * (1 - t))) + (c * (root * t));
    }

    private static double Fraction(double value) => value - Math.Floor(value);
}
