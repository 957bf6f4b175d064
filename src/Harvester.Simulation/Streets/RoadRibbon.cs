using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>Adds strips of one colour along a road's curve.</summary>
internal sealed class RoadRibbon(Road road, IReadOnlyList<double> stations, GroundMesh mesh)
{
    /// <summary>Adds a strip along the whole road, except for pieces whose centre fails a test.</summary>
    public void Lay(Rail left, Rail right, Rgb colour, Surface surface, SurfaceKind kind, Func<double, bool>? isPresent = null)
    {
        for (int i = 1; i < stations.Count; i++)
        {
            if (isPresent?.Invoke((stations[i - 1] + stations[i]) / 2) ?? true)
            {
                Piece(stations[i - 1], stations[i], left, right, colour, surface, kind);
            }
        }
    }

    private void Piece(double from, double to, Rail left, Rail right, Rgb colour, Surface surface, SurfaceKind kind) =>
        mesh.AddQuad(Place(from, left), Place(from, right), Place(to, right), Place(to, left), colour, surface, kind);

    private Vector3D Place(double distance, Rail rail) => road.Curve.OffsetAt(distance, rail.RightOffset) + (Horizontal.Up * rail.Height);
}
