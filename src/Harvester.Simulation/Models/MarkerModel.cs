using Harvester.Geometry;
using Harvester.Geometry.Calibration;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>The balls of the calibration: magenta, luminous by day and at night.</summary>
public static class MarkerModel
{
    private const int Sides = 24;
    private const int Rings = 12;
    private static readonly Rgb Magenta = new(255, 0, 255);

    /// <summary>A ball at its position.</summary>
    public static MeshInstance Of(PlannedMarker marker)
    {
        var radii = new Vector3D(marker.RadiusMetres, marker.RadiusMetres, marker.RadiusMetres);
        Mesh ball = new MeshBuilder().AddEllipsoid(Vector3D.Zero, radii, Sides, Rings, Magenta, Surface.Lamp).Build();
        return new MeshInstance(ball, new Pose(marker.Centre, Axes.Identity), 0);
    }
}
