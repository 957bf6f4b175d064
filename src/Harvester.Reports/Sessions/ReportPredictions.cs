using System.Text.Json;
using Harvester.Datasets.Colours;
using Harvester.Datasets.Detections;
using Harvester.Exports.Predictions;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Sessions;

/// <summary>Predictions and their evaluation in the data of a report, as the page's scripts read them.</summary>
internal static class ReportPredictions
{
    private const int FigureDecimals = 6;
    private const int CurveDecimals = 4;
    private const int PixelDecimals = 1;
    private const int ScoreDecimals = 3;
    private const int Overlap75 = 5;
    private const int WorstFrames = 50;

    /// <summary>Writes one object.</summary>
    /// <param name="json">Receives it.</param>
    /// <param name="evaluation">The evaluation.</param>
    /// <param name="places">Places of the page's frames in the session, ascending.</param>
    /// <param name="frames">The page's frames.</param>
    public static void Write(
        Utf8JsonWriter json,
        PredictionEvaluation evaluation,
        IReadOnlyList<int> places,
        IReadOnlyList<FrameLabel> frames
    )
    {
        json.WriteStartObject();
        json.WriteString("format", evaluation.Format);
        json.Number("minScore", evaluation.MinScore, FigureDecimals);
        WriteFigures(json, evaluation);
        json.WriteStartArray("classes");
        for (int place = 0; place < evaluation.Classes.Count; place++)
        {
            WriteClass(json, evaluation.Classes[place], evaluation.Tallies[place], evaluation.Groups.Classes[place]);
        }

        json.WriteEndArray();
        WriteCounts(json, "all", [evaluation.Groups.All]);
        WriteCounts(json, "sizes", evaluation.Groups.Sizes);
        WriteCounts(json, "distances", evaluation.Groups.Distances);
        WriteCounts(json, "occlusions", evaluation.Groups.Occlusions);
        IReadOnlyDictionary<int, FrameOutcome> outcomes = evaluation.OutcomesOf([.. places]);
        json.WriteStartArray("frames");
        foreach (int place in places)
        {
            WriteFrame(json, outcomes.GetValueOrDefault(place), evaluation.ToSessionPixels);
        }

        json.WriteEndArray();
        WriteWorst(json, [.. places.Zip(frames).Select(pair => (pair.Second.Frame, outcomes.GetValueOrDefault(pair.First)))]);
        json.WriteEndObject();
    }

    /// <summary>The twelve figures of COCO's summary.</summary>
    private static void WriteFigures(Utf8JsonWriter json, PredictionEvaluation evaluation)
    {
        (string Name, Func<ClassTally, double?> Of)[] figures =
        [
            ("AP", tally => tally.AveragePrecision(0)),
            ("AP50", tally => tally.AveragePrecisionAt(0)),
            ("AP75", tally => tally.AveragePrecisionAt(Overlap75)),
            ("APsmall", tally => tally.AveragePrecision(1)),
            ("APmedium", tally => tally.AveragePrecision(2)),
            ("APlarge", tally => tally.AveragePrecision(3)),
            ("AR1", tally => tally.AverageRecall(0)),
            ("AR10", tally => tally.AverageRecall(1)),
            ("AR100", tally => tally.AverageRecall(2)),
            ("ARsmall", tally => tally.AverageRecallIn(1)),
            ("ARmedium", tally => tally.AverageRecallIn(2)),
            ("ARlarge", tally => tally.AverageRecallIn(3)),
        ];
        json.WriteStartObject("figures");
        foreach ((string name, Func<ClassTally, double?> of) in figures)
        {
            json.Number(name, evaluation.MeanOf(of), FigureDecimals);
        }

        json.WriteEndObject();
    }

    private static void WriteClass(Utf8JsonWriter json, PredictedClass kind, ClassTally tally, OutcomeCount count)
    {
        json.WriteStartObject();
        json.WriteString("name", kind.Name);
        json.WriteString("colour", $"#{ClassColours.Of(kind.Kind):x6}");
        json.WriteNumber("objects", tally.CountIn(0));
        json.Number("ap", tally.AveragePrecision(0), FigureDecimals);
        json.Number("ap50", tally.AveragePrecisionAt(0), FigureDecimals);
        json.Number("ap75", tally.AveragePrecisionAt(Overlap75), FigureDecimals);
        json.Number("small", tally.AveragePrecision(1), FigureDecimals);
        json.Number("medium", tally.AveragePrecision(2), FigureDecimals);
        json.Number("large", tally.AveragePrecision(3), FigureDecimals);
        json.Number("recall", tally.AverageRecall(2), FigureDecimals);
        WriteCount(json, count);
        if (tally.CountIn(0) > 0)
        {
            json.Numbers("curve50", tally.Precisions(0), CurveDecimals);
            json.Numbers("curve75", tally.Precisions(Overlap75), CurveDecimals);
        }

        json.WriteEndObject();
    }

    private static void WriteCounts(Utf8JsonWriter json, string name, IEnumerable<OutcomeCount> counts)
    {
        json.WriteStartArray(name);
        foreach (OutcomeCount count in counts)
        {
            json.WriteStartObject();
            json.WriteString("name", count.Name);
            WriteCount(json, count);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteCount(Utf8JsonWriter json, OutcomeCount count)
    {
        json.WriteNumber("matches", count.Matches);
        json.WriteNumber("misses", count.Misses);
        json.WriteNumber("false", count.FalsePositives);
    }

    private static void WriteFrame(Utf8JsonWriter json, FrameOutcome? outcome, double shift)
    {
        json.WriteStartObject();
        json.WriteStartArray("boxes");
        foreach (PredictionOutcome item in outcome?.Predictions ?? [])
        {
            json.WriteStartObject();
            WriteBox(json, item.Box.Box, shift);
            json.WriteNumber("class", item.Box.Class);
            json.Number("score", item.Box.Score, ScoreDecimals);
            json.WriteString("outcome", JsonName.Of(item.Kind));
            if (item.ObjectId is { } id)
            {
                json.WriteNumber("object", id);
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("missed");
        foreach (TruthObject item in outcome?.Missed ?? [])
        {
            json.WriteStartObject();
            WriteBox(json, item.Box.Box, shift);
            json.WriteNumber("class", item.Box.Class);
            if (item.Label is { } label)
            {
                json.WriteNumber("object", label.Id);
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WriteBox(Utf8JsonWriter json, Box2D box, double shift) =>
        json.Numbers("box", [box.XMin + shift, box.YMin + shift, box.XMax + shift, box.YMax + shift], PixelDecimals);

    private static void WriteWorst(Utf8JsonWriter json, IEnumerable<(int Frame, FrameOutcome? Outcome)> frames)
    {
        json.WriteStartArray("worst");
        foreach (
            (int frame, FrameOutcome? outcome) in frames
                .Where(frame => frame.Outcome?.Errors > 0)
                .OrderByDescending(frame => frame.Outcome!.Errors)
                .ThenBy(frame => frame.Frame)
                .Take(WorstFrames)
        )
        {
            json.WriteStartObject();
            json.WriteNumber("frame", frame);
            json.WriteNumber("misses", outcome!.Missed.Count);
            json.WriteNumber("false", outcome.FalsePositives);
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }
}
