namespace Harvester.Geometry.PixelMaps;

/// <summary>The pixels of a cell as they were painted.</summary>
/// <param name="PaintedAt">When it was painted, in changes of the samples.</param>
/// <param name="Number">The number of all pixels, if <paramref name="Numbers"/> is null.</param>
/// <param name="Numbers">The numbers of the pixels row by row, border included; null if all are the same.</param>
internal readonly record struct PaintedCell(int PaintedAt, ushort Number, ushort[]? Numbers);
