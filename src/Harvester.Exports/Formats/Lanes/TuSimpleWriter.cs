using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Lanes;

/// <summary>
/// Writes TuSimple lanes: the column of each marking in every tenth row, one JSON line per frame. See docs/exports/tusimple.md.
/// </summary>
internal sealed class TuSimpleWriter(ExportOptions options) : IDatasetWriter
{
    private const int RowStep = 10;
    private const int Absent = -2;

    /// <summary>TuSimple's rows begin at the upper third: 240 of 720.</summary>
    private const int RowsAbove = 3;

    /// <summary>TuSimple's evaluation scores a frame as if it had at most five lanes.</summary>
    private const int MaxLanes = 5;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        // Without known lanes, the frame would say that there are none.
        if (frame.Label.Lanes is not { Status: LaneStatus.Known } lanes)
        {
            return default;
        }

        string image = $"clips/{frame.SequenceIndex:D4}/{frame.FrameInSequence:D8}{frame.ImageExtension}";
        output.Image(image, frame);
        output.Part(frame.Split, Line(lanes, frame.Label.Camera.Height, image, options.Lanes));
        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        options.Splits.Splits.Select(split => new AggregateFile($"label_data_{split.Name}.json", [AggregateSection.Lines(split.Name)]));

    private static string Line(LanesLabel lanes, int height, string image, LaneSelection selection)
    {
        int first = ((height / RowsAbove) + RowStep - 1) / RowStep * RowStep;
        int[] rows = [.. Enumerable.Range(0, height).Where(row => row >= first && row % RowStep == 0)];
        (LaneLineView Marking, int[] Columns)[] crossing =
        [
            .. lanes
                .Lines.GroupBy(view => view.Index)
                .Select(marking => (marking.First(), rows.Select(row => ColumnAt(marking, row)).ToArray()))
                .Where(marking => marking.Item2.Any(column => column != Absent)),
        ];
        HashSet<int> written =
            selection == LaneSelection.All
                ? [.. crossing.Select(marking => marking.Marking.Index)]
                : Nearest([.. crossing.Select(marking => marking.Marking)]);
        return JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteStartArray("lanes");
            foreach ((LaneLineView marking, int[] columns) in crossing.OrderBy(marking => marking.Marking.Index))
            {
                if (written.Contains(marking.Index))
                {
                    json.WriteStartArray();
                    Array.ForEach(columns, json.WriteNumberValue);
                    json.WriteEndArray();
                }
            }

            json.WriteEndArray();
            json.WriteStartArray("h_samples");
            Array.ForEach(rows, json.WriteNumberValue);
            json.WriteEndArray();
            json.WriteString("raw_file", image);
            json.WriteEndObject();
        });
    }

    /// <summary>
    /// The indices of the nearest markings: counted from the car to either side, and of two with the same count the one that begins nearer
    /// to the camera's axis.
    /// </summary>
    private static HashSet<int> Nearest(IReadOnlyList<LaneLineView> markings)
    {
        int[] left = [.. markings.Where(view => view.IsLeftOfCar).Select(view => view.Index).OrderDescending()];
        int[] right = [.. markings.Where(view => !view.IsLeftOfCar).Select(view => view.Index).Order()];
        return
        [
            .. markings
                .OrderBy(view => Array.IndexOf(view.IsLeftOfCar ? left : right, view.Index))
                .ThenBy(view => Math.Abs(view.Points[0].InCamera.X))
                .Take(MaxLanes)
                .Select(view => view.Index),
        ];
    }

    /// <summary>The pixel column in which a marking crosses the middle of a row; if it crosses twice, the nearer one.</summary>
    private static int ColumnAt(IEnumerable<LaneLineView> views, int row) =>
        RowCrossing.Of(views, row) is { } x ? (int)Math.Floor(x) : Absent;
}
