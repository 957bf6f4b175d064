namespace Harvester.Geometry.Paint;

/// <summary>A stretch of a line that runs over several stretches and links.</summary>
/// <param name="Run">Number of the line.</param>
/// <param name="Order">Place of the stretch on the line, from 0.</param>
/// <param name="Link">Index of the link.</param>
/// <param name="Line">The stretch.</param>
/// <param name="IsReversed">Whether the line runs against the link's direction.</param>
internal sealed record PaintPiece(int Run, int Order, int Link, LinePaint Line, bool IsReversed);
