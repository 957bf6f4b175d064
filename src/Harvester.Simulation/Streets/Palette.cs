using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Streets;

/// <summary>The colours of the ground.</summary>
internal static class Palette
{
    public static readonly Rgb Asphalt = new(78, 79, 82);
    public static readonly Rgb Dirt = new(134, 112, 84);
    public static readonly Rgb Pavement = new(150, 147, 140);
    public static readonly Rgb Kerb = new(176, 173, 166);
    public static readonly Rgb Grass = new(96, 116, 66);
    public static readonly Rgb DryGrass = new(146, 134, 88);
    public static readonly Rgb Concrete = new(158, 156, 150);
    public static readonly Rgb White = new(226, 226, 220);
    public static readonly Rgb Yellow = new(222, 178, 60);
}
