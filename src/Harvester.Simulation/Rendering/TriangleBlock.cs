using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Up to four triangles, coordinate by coordinate, so that one test serves all of them.</summary>
internal readonly struct TriangleBlock
{
    /// <summary>Maximum number of triangles.</summary>
    public const int Width = 4;

    private readonly QuadVector _a;
    private readonly QuadVector _ab;
    private readonly QuadVector _ac;

    /// <param name="triangles">The triangles; the remaining places hold points, which no ray hits.</param>
    public TriangleBlock(ReadOnlySpan<MeshTriangle> triangles)
    {
        for (int i = 0; i < triangles.Length; i++)
        {
            ref readonly MeshTriangle triangle = ref triangles[i];
            _a = _a.With(i, triangle.A);
            _ab = _ab.With(i, triangle.B - triangle.A);
            _ac = _ac.With(i, triangle.C - triangle.A);
        }
    }

    /// <summary>
    /// Shortens a ray to the nearest of the triangles, if one is nearer than the limit. This is the test of Möller and Trumbore; both sides
    /// of a triangle count, edges included. The quotients of a triangle that the ray is parallel to are infinite or undefined and fail the
    /// comparisons.
    /// </summary>
    /// <returns>Whether the ray was shortened.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Shorten(in QuadVector origin, in QuadVector direction, ref double limit)
    {
        // Solves origin + t·direction = a + u·ab + v·ac by Cramer's rule (Möller and Trumbore 1997): with p = direction × ac and
        // q = (origin - a) × ab, the determinant is ab · p, u = (origin - a) · p, v = direction · q and t = ac · q, each over the
        // determinant.
        QuadVector p = direction.Cross(_ac);
        Vector256<double> determinant = _ab.Dot(p);
        QuadVector fromA = origin - _a;
        Vector256<double> u = fromA.Dot(p) / determinant;
        Vector256<double> zero = Vector256<double>.Zero;
        Vector256<double> one = Vector256<double>.One;
        Vector256<double> hits = Vector256.GreaterThanOrEqual(u, zero) & Vector256.LessThanOrEqual(u, one);
        if (hits == zero)
        {
            return false;
        }

        QuadVector q = fromA.Cross(_ab);
        Vector256<double> v = direction.Dot(q) / determinant;
        Vector256<double> distance = _ac.Dot(q) / determinant;
        hits &=
            Vector256.GreaterThanOrEqual(v, zero)
            & Vector256.LessThanOrEqual(u + v, one)
            & Vector256.GreaterThanOrEqual(distance, zero)
            & Vector256.LessThan(distance, Vector256.Create(limit));
        uint places = hits.ExtractMostSignificantBits();
        if (places == 0)
        {
            return false;
        }

        Vector256<double> near = Vector256.ConditionalSelect(hits, distance, Vector256.Create(double.PositiveInfinity));
        Vector128<double> nearer = Vector128.MinNative(near.GetLower(), near.GetUpper());
        limit = nearer[0] < nearer[1] ? nearer[0] : nearer[1];
        return true;
    }

    /// <summary>
    /// The unit normal, to either side, of the triangle that a ray meets at a distance: of those whose plane it meets there, the one that
    /// contains the place best.
    /// </summary>
    public Vector3D NormalAt(Vector3D origin, Vector3D direction, double distance)
    {
        Vector3D place = origin + (direction * distance);
        Vector3D best = Vector3D.Zero;
        double least = double.PositiveInfinity;
        for (int i = 0; i < Width; i++)
        {
            Vector3D ab = At(_ab, i);
            Vector3D ac = At(_ac, i);
            Vector3D normal = ab.Cross(ac);
            double area = normal.Length;
            if (area == 0)
            {
                continue;
            }

            // The three areas that the place makes with the sides add up to that of the triangle if it lies inside.
            Vector3D a = At(_a, i) - place;
            double areas = (a.Cross(a + ab).Length + a.Cross(a + ac).Length + (a + ab).Cross(a + ac).Length) / area;
            if (areas < least)
            {
                (least, best) = (areas, normal / area);
            }
        }

        return best;
    }

    private static Vector3D At(in QuadVector vectors, int place) => new(vectors.X[place], vectors.Y[place], vectors.Z[place]);
}
