using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>A cubic piece of a road's curve: the position at t, from 0 to 1, is Start + Linear t + Square t² + Cubic t³.</summary>
internal readonly record struct CurvePiece(Vector3D Start, Vector3D Linear, Vector3D Square, Vector3D Cubic)
{
    /// <summary>The Hermite piece from one point to another with given tangents at its ends.</summary>
    public static CurvePiece Between(Vector3D start, Vector3D end, Vector3D startTangent, Vector3D endTangent)
    {
        double size = (end - start).Length;
        Vector3D m = startTangent * size;
        Vector3D n = endTangent * size;
        return new CurvePiece(start, m, ((end - start) * 3) - (m * 2) - n, ((start - end) * 2) + m + n);
    }

    /// <summary>Position and derivatives with respect to t.</summary>
    public (Vector3D Position, Vector3D Derivative, Vector3D Second) At(double t) =>
        (
            Start + ((Linear + ((Square + (Cubic * t)) * t)) * t),
            Linear + (((Square * 2) + (Cubic * (3 * t))) * t),
            (Square * 2) + (Cubic * (6 * t))
        );
}
