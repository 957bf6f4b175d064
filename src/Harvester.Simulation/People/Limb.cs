using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.People;

/// <summary>A round limb through points, whose rings lie across it.</summary>
/// <param name="sides">Number of faces around; at least 3.</param>
/// <param name="aside">A unit vector about which the limb bends; its rings are turned alike by it.</param>
internal sealed class Limb(int sides, Vector3D aside)
{
    private readonly List<(Vector3D Centre, double Radius)> _rings = [];

    /// <summary>Adds a ring.</summary>
    /// <param name="centre">Its centre, metres; not that of the ring before.</param>
    /// <param name="radius">Metres.</param>
    public void Add(Vector3D centre, double radius) => _rings.Add((centre, radius));

    /// <summary>Adds the faces between the rings, and both ends.</summary>
    public void AddTo(MeshBuilder builder, Rgb colour)
    {
        Loft loft = new(sides);
        for (int i = 0; i < _rings.Count; i++)
        {
            Vector3D along = (_rings[Math.Min(i + 1, _rings.Count - 1)].Centre - _rings[Math.Max(i - 1, 0)].Centre).Normalized();

            // A limb that points along the vector given, as an arm held aside, is turned by another one.
            const double nearlyParallel = 0.9;
            Vector3D about = Math.Abs(along.Dot(aside)) < nearlyParallel ? aside : new Vector3D(0, 0, 1);
            Vector3D first = (about - (along * about.Dot(along))).Normalized();
            loft.Add(_rings[i].Centre, first * _rings[i].Radius, along.Cross(first) * _rings[i].Radius);
        }

        loft.AddTo(builder, colour);
    }
}
