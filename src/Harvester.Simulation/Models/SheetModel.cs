using Harvester.Geometry;
using Harvester.Geometry.PixelMaps.Coded;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Models;

/// <summary>The sheets of masks from photographs: magenta, luminous by day and at night, without shadows.</summary>
internal static class SheetModel
{
    private static readonly Rgb Magenta = new((byte)ScreenSheet.Colour.X, (byte)ScreenSheet.Colour.Y, (byte)ScreenSheet.Colour.Z);

    /// <summary>A sheet at its position.</summary>
    public static MeshInstance Of(ScreenSheet sheet)
    {
        var pose = new Pose(sheet.A, Axes.Identity);
        Mesh mesh = new MeshBuilder { CastsShadows = false }
            .AddQuad(Vector3D.Zero, sheet.B - sheet.A, sheet.C - sheet.A, sheet.D - sheet.A, Magenta, Surface.Lamp)
            .Build();
        return new MeshInstance(mesh, pose, 0);
    }
}
