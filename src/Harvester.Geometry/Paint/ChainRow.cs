namespace Harvester.Geometry.Paint;

/// <summary>A row of a link in a chain of links.</summary>
/// <param name="Link">Index of the link.</param>
/// <param name="Row">Number of the row on the link.</param>
/// <param name="IsForward">Whether the chain follows the link from its start to its end.</param>
/// <param name="Station">Middle of the row, metres from the start of the chain.</param>
/// <param name="Evidence">What images show of it; null if it was not seen.</param>
internal readonly record struct ChainRow(int Link, int Row, bool IsForward, double Station, PaintRow? Evidence)
{
    /// <summary>An offset to the right of the chain from one to the right of the link, or the reverse.</summary>
    public double Turned(double offset) => IsForward ? offset : -offset;
}
