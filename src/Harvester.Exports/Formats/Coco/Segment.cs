namespace Harvester.Exports.Formats.Coco;

/// <summary>A segment of a panoptic image: the pixels of one colour.</summary>
/// <param name="Id">The colour, red + 256 green + 65536 blue.</param>
/// <param name="Left">First column.</param>
/// <param name="Top">First row.</param>
/// <param name="Right">Column after the last.</param>
/// <param name="Bottom">Row after the last.</param>
/// <param name="Area">Number of pixels.</param>
internal sealed record Segment(int Id, int Left, int Top, int Right, int Bottom, int Area)
{
    /// <summary>The segment extended by a run of pixels, in the row of its last run or below.</summary>
    public Segment With(int left, int right, int row) =>
        this with
        {
            Left = Math.Min(Left, left),
            Right = Math.Max(Right, right),
            Bottom = row + 1,
            Area = Area + right - left,
        };
}
