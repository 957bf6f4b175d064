namespace Harvester.Simulation.Rendering;

/// <summary>
/// The material that a ray reports of a surface, by the hashes of the real game. As there, paint on a road has no material of its own: rays
/// report the asphalt below it.
/// </summary>
internal static class SurfaceMaterial
{
    private const uint Tarmac = 0x10DD5498;
    private const uint ConcretePavement = 0x78239B1A;
    private const uint Brick = 0x61B1F936;
    private const uint Leaves = 0x8653C6CD;
    private const uint Grass = 0x4F747B87;
    private const uint MetalSolidSmall = 0xA9BC4217;
    private const uint MetalRailing = 0x7D368D93;
    private const uint Spine = 0x01F3C404;

    /// <summary>The hash of the material of a kind of surface; 0 for none.</summary>
    public static uint Of(SurfaceKind kind) =>
        kind switch
        {
            SurfaceKind.Road or SurfaceKind.Marking => Tarmac,
            SurfaceKind.Pavement => ConcretePavement,
            SurfaceKind.Building => Brick,
            SurfaceKind.Vegetation => Leaves,
            SurfaceKind.Terrain => Grass,
            SurfaceKind.Pole => MetalSolidSmall,
            SurfaceKind.Fence => MetalRailing,
            SurfaceKind.Person => Spine,
            _ => 0,
        };
}
