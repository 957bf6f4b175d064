using System.Globalization;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Formats.Video;

/// <summary>
/// Writes a video for each view of each place, in which frame k is line k of labels.jsonl beside it. See docs/exports/video.md.
/// </summary>
/// <param name="isLossless">Whether the images keep every bit; masks and depths always do.</param>
internal sealed class VideoWriter(bool isLossless) : IDatasetWriter
{
    private const string FramesPart = "frames";
    private const string LabelsPart = "labels";
    private const string MasksPart = "masks";

    /// <summary>Depths of all pixels where they are known, otherwise those that rays measured.</summary>
    private const string DepthPart = "depth";

    /// <summary>Name of the file with the label lines.</summary>
    public const string Labels = "labels.jsonl";

    /// <summary>Name of the video of the images.</summary>
    public static string FramesOf(bool isLossless) => isLossless ? "frames.mkv" : "frames.mp4";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        if (frame.RateHz <= 0)
        {
            throw frame.Problem("session.json does not say how many moments a second it has, which a video needs. Choose another format.");
        }

        // The name of a part carries what the video needs to know: its rate and its folder.
        string view = frame.Label.View is { } name ? "-" + name : "";
        string sequence = string.Create(
            CultureInfo.InvariantCulture,
            $"{frame.RateHz:0.######} {frame.Split}/sequence-{frame.SequenceIndex:D4}{view}"
        );
        output.StagedImage($"{FramesPart} {sequence}", frame);
        output.Part($"{LabelsPart} {sequence}", frame.LabelText);
        if (frame.MaskPath is { } mask)
        {
            Stage(output, MasksPart, sequence, frame, mask);
        }

        if (frame.DepthPath is { } depth)
        {
            Stage(output, DepthPart, sequence, frame, depth);
        }

        return default;
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts)
    {
        foreach (string part in parts.Keys)
        {
            string[] words = part.Split(' ', 3);
            if (words.Length < 3 || !double.TryParse(words[1], NumberStyles.Float, CultureInfo.InvariantCulture, out _))
            {
                throw new DatasetFormatException(
                    $"A journal of the export has a damaged part '{part}'. Delete the folder, and export again."
                );
            }

            (string kind, string rate, string folder) = (words[0], words[1], words[2]);
            if (parts[part] != parts.GetValueOrDefault($"{LabelsPart} {rate} {folder}"))
            {
                throw new DatasetFormatException(
                    $"Only some frames of {folder} have {kind}, so that frames of their video would not be those of the labels. "
                        + "Export sessions with and without them separately."
                );
            }

            yield return kind switch
            {
                LabelsPart => new AggregateFile($"{folder}/{Labels}", [AggregateSection.Lines(part)]),
                FramesPart => new AggregateFile(
                    $"{folder}/{FramesOf(isLossless)}",
                    [AggregateSection.MadeBy(part, (target, images) => VideoEncoder.WriteColours(target, images, rate, isLossless))]
                ),
                _ => new AggregateFile(
                    $"{folder}/{kind}.mkv",
                    [AggregateSection.MadeBy(part, (target, maps) => VideoEncoder.WriteMaps(target, maps, rate))]
                ),
            };
        }
    }

    private static void Stage(FrameOutput output, string kind, string sequence, ExportFrame frame, string path) =>
        output.StagedPart(
            $"{kind} {sequence}",
            $"{frame.Name}-{kind}.png",
            stream =>
            {
                using FileStream map = InputFile.OpenRead(path);
                map.CopyTo(stream);
            }
        );
}
