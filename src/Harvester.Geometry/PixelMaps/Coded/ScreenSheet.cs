namespace Harvester.Geometry.PixelMaps.Coded;

/// <summary>A flat sheet of one bright colour in the world: part of the screen behind an object.</summary>
/// <param name="A">A corner, world frame, metres.</param>
/// <param name="B">The next corner.</param>
/// <param name="C">The corner opposite the first.</param>
/// <param name="D">The last corner.</param>
public sealed record ScreenSheet(Vector3D A, Vector3D B, Vector3D C, Vector3D D)
{
    /// <summary>The colour of sheets: magenta, each channel 0 to 255.</summary>
    public static Vector3D Colour { get; } = new(255, 0, 255);
}
