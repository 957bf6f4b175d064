using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>The surfaces that the renderer drew.</summary>
internal sealed class SurfacePort(SimulatedGame game) : ISurfaceTruth
{
    public InstanceMap Draw(ImageSize image, Func<int, SemanticClass> classOf)
    {
        RenderTarget picture = game.Render(image);
        var map = new InstanceMap(image);
        for (int i = 0; i < map.Ids.Length; i++)
        {
            map.Ids[i] = (ushort)(picture.Handles[i] != 0 ? classOf(picture.Handles[i]) : ClassOf(picture.Kinds[i]));
        }

        return map;
    }

    public IReadOnlyList<Vector3D> Normals(ImageSize image) =>
        [.. game.RenderNormals(image).Select(static normal => new Vector3D(normal.X, normal.Y, normal.Z))];

    public (float[] Metres, int[] Entities) Surfaces(ImageSize image)
    {
        RenderTarget picture = game.Render(image);
        return ([.. picture.Depth], [.. picture.Handles]);
    }

    /// <summary>The class of a surface of the static world.</summary>
    internal static SemanticClass ClassOf(SurfaceKind kind) =>
        kind switch
        {
            SurfaceKind.Road => SemanticClass.Road,
            SurfaceKind.Pavement => SemanticClass.Pavement,
            SurfaceKind.Marking => SemanticClass.LaneMarking,
            SurfaceKind.Building => SemanticClass.Building,
            SurfaceKind.Vegetation => SemanticClass.Vegetation,
            SurfaceKind.Terrain => SemanticClass.Terrain,
            SurfaceKind.Sky => SemanticClass.Sky,
            SurfaceKind.Pole => SemanticClass.Pole,
            SurfaceKind.Fence => SemanticClass.Fence,
            _ => SemanticClass.Other,
        };
}
