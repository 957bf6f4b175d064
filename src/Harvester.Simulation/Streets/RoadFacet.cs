using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>Two triangles of asphalt; their common edge runs from the near left corner to the far right one.</summary>
/// <remarks>Positions on it are fractions: along from the near side to the far one, across from the left to the right.</remarks>
internal readonly record struct RoadFacet(Vector3D NearLeft, Vector3D NearRight, Vector3D FarRight, Vector3D FarLeft)
{
    public Vector3D At(double along, double across) =>
        along <= across
            ? NearLeft + ((NearRight - NearLeft) * across) + ((FarRight - NearRight) * along)
            : NearLeft + ((FarLeft - NearLeft) * along) + ((FarRight - FarLeft) * across);

    /// <summary>Quadrilaterals that cover a rectangle of it; each lies in one of the triangles.</summary>
    public IEnumerable<Vector3D[]> Cover(double from, double to, double left, double right)
    {
        double seamFrom = Math.Clamp(left, from, to);
        double seamTo = Math.Clamp(right, from, to);
        if (seamFrom > from)
        {
            yield return [At(from, left), At(from, right), At(seamFrom, right), At(seamFrom, left)];
        }

        if (seamTo > seamFrom)
        {
            yield return [At(seamFrom, left), At(seamFrom, seamFrom), At(seamTo, seamTo), At(seamTo, left)];
            yield return [At(seamFrom, seamFrom), At(seamFrom, right), At(seamTo, right), At(seamTo, seamTo)];
        }

        if (seamTo < to)
        {
            yield return [At(seamTo, left), At(seamTo, right), At(to, right), At(to, left)];
        }
    }
}
