namespace Harvester.Exports.Formats.OpenLabel;

/// <summary>Writes ASAM OpenLABEL: a file per place, and its images. See docs/exports/openlabel.md.</summary>
internal sealed class OpenLabelWriter : IDatasetWriter
{
    /// <summary>The object that has the lane lines.</summary>
    public const int LaneObject = 1 << 16;

    /// <summary>The object that has the ignore regions.</summary>
    public const int IgnoreObject = LaneObject + 1;

    /// <summary>Type of the object that has the lane lines.</summary>
    public const string LaneType = "laneLines";

    /// <summary>Type of the object that has the ignore regions.</summary>
    public const string IgnoreType = "ignoreRegions";

    private const string FramesPrefix = "frames ";
    private const string StreamPrefix = "stream ";
    private const string ObjectsPrefix = "objects ";
    private const string ActionsPrefix = "actions ";

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string sequence = $"{frame.Split}/{frame.SequenceIndex:D4}";
        string image = $"images/{sequence}/{frame.FrameInSequence:D8}{frame.ImageExtension}";
        output.Image(image, frame);
        if (frame.FrameInSequence == 0)
        {
            output.Part(StreamPrefix + sequence, OpenLabelStream.Text(frame.Label.Camera));
        }

        output.Part(FramesPrefix + sequence, $"\"{frame.FrameInSequence}\":{OpenLabelFrame.Text(frame, image)}");
        output.Part(ObjectsPrefix + sequence, ObjectsPart(frame));
        if (frame.Label.Events is { Count: > 0 } events)
        {
            output.Part(ActionsPrefix + sequence, OpenLabelActions.PartOf(frame.FrameInSequence, events));
        }

        return new WrittenObjects(frame.Objects.Count, frame.Ignored.Count);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts
            .Keys.Where(part => part.StartsWith(FramesPrefix, StringComparison.Ordinal))
            .Select(part => part[FramesPrefix.Length..])
            .Select(sequence => new AggregateFile(
                $"labels/{sequence}.json",
                [
                    AggregateSection.Literal(OpenLabelStream.Head),
                    AggregateSection.Joined(StreamPrefix + sequence, ""),
                    .. parts.ContainsKey(ActionsPrefix + sequence)
                        ?
                        [
                            AggregateSection.Literal("},\"actions\":{"),
                            AggregateSection.Summary(ActionsPrefix + sequence, OpenLabelActions.Write),
                        ]
                        : Array.Empty<AggregateSection>(),
                    AggregateSection.Literal("},\"frames\":{\n"),
                    AggregateSection.Joined(FramesPrefix + sequence, ",\n"),
                    AggregateSection.Literal("\n},\n"),
                    AggregateSection.Summary(ObjectsPrefix + sequence, OpenLabelObjects.Write),
                    AggregateSection.Literal("\n}}}\n"),
                ]
            ));

    /// <summary>The objects of a frame, with their types.</summary>
    private static string ObjectsPart(ExportFrame frame)
    {
        IEnumerable<(int Id, string Type)> objects = frame.Objects.Select(item => (item.Label.Id, OpenLabelFrame.TypeOf(item)));
        if (frame.Label.Lanes?.Lines.Count > 0)
        {
            objects = objects.Append((LaneObject, LaneType));
        }

        if (frame.Ignored.Count > 0)
        {
            objects = objects.Append((IgnoreObject, IgnoreType));
        }

        return OpenLabelObjects.PartOf(frame.FrameInSequence, objects);
    }
}
