namespace Harvester.Geometry.PixelMaps;

/// <summary>A stretch of a cell's border that shows one number, in steps of the walk around it; steps count on beyond one round.</summary>
internal readonly record struct BorderRun(int Start, int End, int Number);
