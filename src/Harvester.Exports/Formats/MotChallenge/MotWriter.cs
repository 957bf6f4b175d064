using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.MotChallenge;

/// <summary>Writes MOTChallenge: a sequence per place with its images and gt.txt. See docs/exports/motchallenge.md.</summary>
internal sealed class MotWriter : IDatasetWriter
{
    /// <summary>Name of the benchmark, with which TrackEval's names of folders begin.</summary>
    public const string Benchmark = "MOT17-";

    private const int PixelDecimals = 3;
    private const int FractionDecimals = 5;

    /// <summary>MOTChallenge counts pixels from 1.</summary>
    private const double PixelShift = 1;

    /// <summary>Ids of ignore regions begin above all object ids.</summary>
    private const int FirstRegion = 1 << 16;

    private const string InfoPrefix = "info ";
    private const string TruthPrefix = "truth ";
    private const string ListPrefix = "list ";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string name = $"sequence-{frame.SequenceIndex:D4}";
        string sequence = $"{Benchmark}{frame.Split}/{name}";
        output.Image($"{sequence}/img1/{frame.FrameInSequence + 1:D6}{frame.ImageExtension}", frame);
        output.Part(InfoPrefix + sequence, MotSequence.PartOf(frame));
        if (frame.FrameInSequence == 0)
        {
            output.Part(ListPrefix + frame.Split, name);
        }

        int objects = 0;
        foreach (ExportObject item in frame.Objects)
        {
            if (MotClasses.Of(item.Label.Class) is { } number)
            {
                double visible = item.Label.VisibleFraction ?? 1;
                output.Part(TruthPrefix + sequence, Line(frame, item.Label.Id, item.Box, number, visible));
                objects++;
            }
        }

        // Only pedestrians are evaluated, so other regions change nothing.
        ExportRegion[] ignored = [.. frame.Ignored.Where(region => region.Kind == ObjectClass.Pedestrian)];
        for (int i = 0; i < ignored.Length; i++)
        {
            output.Part(TruthPrefix + sequence, Line(frame, FirstRegion + i, ignored[i].Box, MotClasses.Distractor, 0));
        }

        return new WrittenObjects(objects, ignored.Length);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts
            .Keys.Where(part => part.StartsWith(InfoPrefix, StringComparison.Ordinal))
            .SelectMany(FilesOf)
            .Concat(
                parts
                    .Keys.Where(part => part.StartsWith(ListPrefix, StringComparison.Ordinal))
                    .Select(part => new AggregateFile(
                        $"seqmaps/{Benchmark}{part[ListPrefix.Length..]}.txt",
                        [AggregateSection.Literal("name\n"), AggregateSection.Lines(part)]
                    ))
            );

    /// <summary>A sequence without objects has an empty gt.txt, because readers require it.</summary>
    private static AggregateFile[] FilesOf(string part)
    {
        string sequence = part[InfoPrefix.Length..];
        return
        [
            new($"{sequence}/gt/gt.txt", [AggregateSection.Lines(TruthPrefix + sequence)]),
            new(
                $"{sequence}/seqinfo.ini",
                [AggregateSection.Summary(part, (writer, frames) => MotSequence.Write(writer, sequence.Split('/')[1], frames))]
            ),
        ];
    }

    private static string Line(ExportFrame frame, int id, Box2D box, int number, double visible)
    {
        string[] sides =
        [
            .. ((double[])[box.XMin + PixelShift, box.YMin + PixelShift, box.Width, box.Height]).Select(side =>
                InvariantNumber.Format(side, PixelDecimals)
            ),
        ];
        return string.Join(
            ',',
            Numbers.Text(frame.FrameInSequence + 1),
            Numbers.Text(id),
            string.Join(',', sides),
            number == MotClasses.Pedestrian ? "1" : "0",
            Numbers.Text(number),
            InvariantNumber.Format(visible, FractionDecimals)
        );
    }
}
