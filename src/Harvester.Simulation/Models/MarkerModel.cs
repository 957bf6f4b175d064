using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>The balls that calibration puts into the world: magenta, shining by day and night.</summary>
public static class MarkerModel
{
    private const int Sides = 24;
    private const int Rings = 12;
    private static readonly Rgb Magenta = new(255, 0, 255);

    /// <summary>A ball in its place.</summary>
    public static MeshInstance Of(PlannedMarker marker)
    {
        var radii = new Vector3D(marker.RadiusMetres, marker.RadiusMetres, marker.RadiusMetres);
        Mesh ball = new MeshBuilder().AddEllipsoid(Vector3D.Zero, radii, Sides, Rings, Magenta, Surface.Lamp).Build();
        return new MeshInstance(ball, new Pose(marker.Centre, Axes.Identity), 0);
    }
}
