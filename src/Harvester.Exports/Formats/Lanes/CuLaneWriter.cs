using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>
/// Writes CULane: the two nearest lines on each side, as points in every tenth row and as a map. See docs/exports/culane.md.
/// </summary>
internal sealed class CuLaneWriter(ExportOptions options) : IDatasetWriter
{
    /// <summary>Folder of the maps, in which lines are 16 pixels wide.</summary>
    public const string Maps = "laneseg_label_w16";

    /// <summary>Distance between the rows of the points, pixels.</summary>
    public const int RowStep = 10;

    private const int Decimals = 3;

    /// <summary>A line with fewer points has no direction, and CULane's evaluation cannot draw it.</summary>
    private const int MinPoints = 2;

    /// <summary>CULane's pixels have integer centres.</summary>
    private const double PixelShift = -0.5;

    private const string ListPrefix = "list ";
    private const string TruthPrefix = "truth ";

    private readonly PngEncoder _png = new();

    /// <summary>The lists of a split: that of its images, and that with maps and flags.</summary>
    public static string[] ListsOf(string split) => [split, split + "_gt"];

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        // Without known lanes, the frame would say that there are none.
        if (frame.Label.Lanes is not { Status: LaneStatus.Known } lanes)
        {
            return default;
        }

        string path = $"sequence-{frame.SequenceIndex:D4}/{frame.FrameInSequence:D8}";
        string image = path + frame.ImageExtension;
        string map = $"{Maps}/{path}.png";
        var size = new ImageSize(frame.Label.Camera.Width, frame.Label.Camera.Height);
        Vector2D[]?[] lines = LinesOf(lanes, size);
        output.Image(image, frame);
        output.Text($"{path}.lines.txt", string.Concat(lines.OfType<Vector2D[]>().Select(Text)));
        output.File(map, stream => _png.WriteGrey8(LaneMap.Of(size, lines), stream));
        output.Part(ListPrefix + frame.Split, "/" + image);
        output.Part(TruthPrefix + frame.Split, $"/{image} /{map} {string.Join(' ', lines.Select(line => line is null ? 0 : 1))}");
        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        options.Splits.Splits.SelectMany(split =>
            ListsOf(split.Name)
                .Zip(
                    [ListPrefix, TruthPrefix],
                    (list, prefix) => new AggregateFile($"list/{list}.txt", [AggregateSection.Lines(prefix + split.Name)])
                )
        );

    /// <summary>The points of the lines by their places, from the bottom of the image upwards; null where there is no line.</summary>
    private static Vector2D[]?[] LinesOf(LanesLabel lanes, ImageSize size)
    {
        var lines = new Vector2D[]?[LanePlaces.Count];
        IReadOnlyDictionary<int, int> places = LanePlaces.Of(lanes.Lines);
        foreach (IGrouping<int, LaneLineView> line in lanes.Lines.GroupBy(view => view.Index).Where(line => places[line.Key] > 0))
        {
            Vector2D[] points = [.. PointsOf(line, size)];
            if (points.Length >= MinPoints)
            {
                lines[places[line.Key] - 1] = points;
            }
        }

        return lines;
    }

    private static IEnumerable<Vector2D> PointsOf(IEnumerable<LaneLineView> line, ImageSize size)
    {
        for (int row = (size.Height - 1) / RowStep * RowStep; row >= 0; row -= RowStep)
        {
            if (RowCrossing.Of(line, row) is { } x)
            {
                // Between the side of the image and the middle of the outer pixel, the middle counts.
                yield return new Vector2D(Math.Clamp(x + PixelShift, 0, size.Width - 1), row);
            }
        }
    }

    private static string Text(Vector2D[] line) =>
        string.Join(' ', line.Select(point => FormattableString.Invariant($"{Numbers.Row(Decimals, point.X)} {point.Y:0}"))) + "\n";
}
