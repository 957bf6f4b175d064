namespace Harvester.Geometry.Paint;

/// <summary>What one image shows of a <see cref="JunctionMouth"/>.</summary>
/// <param name="Image">Number of the image.</param>
/// <param name="Left">Offset of the left border of the first column, metres.</param>
/// <param name="Seen">First and last distance of which each column was seen, metres from the junction's node; NaN if nothing was.</param>
internal sealed record MouthView(int Image, double Left, IReadOnlyList<(float From, float To)> Seen)
{
    /// <summary>Width of a column, metres: a tenth of the shortest stop line.</summary>
    public const double ColumnWidth = 0.25;

    /// <summary>Share of a mark that must be seen for the image to show it; the rest may be behind a vehicle.</summary>
    private const double MinShare = 0.8;

    /// <summary>Whether the camera looks down on the mouth, so that a picture shows paint without the sky's reflections.</summary>
    public bool IsFromAbove { get; init; }

    public double OffsetOf(int column) => Left + ((column + 0.5) * ColumnWidth);

    public int ColumnAt(double offset) => (int)Math.Floor((offset - Left) / ColumnWidth);

    /// <summary>Whether a column was seen from one distance to another.</summary>
    public bool Shows(int column, double from, double to) =>
        column >= 0 && column < Seen.Count && Seen[column].From <= from && Seen[column].To >= to;

    /// <summary>Whether the ground of a mark was seen.</summary>
    public bool Shows(SeenMark mark)
    {
        int first = ColumnAt(mark.Left);
        int last = ColumnAt(mark.Right);
        int seen = 0;
        for (int column = first; column <= last; column++)
        {
            seen += Shows(column, mark.From, mark.To) ? 1 : 0;
        }

        return seen >= MinShare * (last - first + 1);
    }
}
