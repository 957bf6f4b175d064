namespace Harvester.Geometry.PixelMaps;

/// <summary>A run of one number along a cell's border, in steps of the walk around it; steps may exceed one round.</summary>
internal readonly record struct BorderRun(int Start, int End, int Number);
