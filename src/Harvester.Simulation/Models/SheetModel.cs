using Harvester.Geometry;
using Harvester.Geometry.PixelMaps.Coded;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>The sheets of coded masks: magenta, luminous by day and at night.</summary>
internal static class SheetModel
{
    private static readonly Rgb Magenta = new((byte)GroundSheet.Colour.X, (byte)GroundSheet.Colour.Y, (byte)GroundSheet.Colour.Z);

    /// <summary>A sheet at its position.</summary>
    public static MeshInstance Of(GroundSheet sheet)
    {
        var pose = new Pose(sheet.A, Axes.Identity);
        Mesh mesh = new MeshBuilder()
            .AddQuad(Vector3D.Zero, sheet.B - sheet.A, sheet.C - sheet.A, sheet.D - sheet.A, Magenta, Surface.Lamp)
            .Build();
        return new MeshInstance(mesh, pose, 0);
    }
}
