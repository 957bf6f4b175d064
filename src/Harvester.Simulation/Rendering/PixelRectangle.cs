namespace Harvester.Simulation.Rendering;

/// <summary>Columns [Left, Right) and rows [Top, Bottom) of an image.</summary>
internal readonly record struct PixelRectangle(int Left, int Top, int Right, int Bottom)
{
    public bool IsEmpty => Left >= Right || Top >= Bottom;
}
