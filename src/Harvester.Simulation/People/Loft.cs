using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.People;

/// <summary>A closed body through elliptical rings.</summary>
/// <param name="sides">Number of faces around; at least 3.</param>
internal sealed class Loft(int sides)
{
    private readonly List<Vector3D[]> _rings = [];

    /// <summary>Adds a ring.</summary>
    /// <param name="centre">Its centre, metres.</param>
    /// <param name="first">The first half axis.</param>
    /// <param name="second">The other half axis.</param>
    public void Add(Vector3D centre, Vector3D first, Vector3D second)
    {
        var ring = new Vector3D[sides];
        for (int i = 0; i < sides; i++)
        {
            double turn = 2 * Math.PI * (i + 0.5) / sides;
            ring[i] = centre + (first * Math.Cos(turn)) + (second * Math.Sin(turn));
        }

        _rings.Add(ring);
    }

    /// <summary>Adds the faces between the rings, and both ends.</summary>
    public void AddTo(MeshBuilder builder, Rgb colour)
    {
        builder.AddPolygon(_rings[0], colour);
        builder.AddPolygon(_rings[^1], colour);
        for (int number = 1; number < _rings.Count; number++)
        {
            (Vector3D[] low, Vector3D[] high) = (_rings[number - 1], _rings[number]);
            for (int i = 0; i < sides; i++)
            {
                int next = (i + 1) % sides;
                builder.AddQuad(low[i], low[next], high[next], high[i], colour);
            }
        }
    }
}
