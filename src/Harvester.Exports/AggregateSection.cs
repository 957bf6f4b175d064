namespace Harvester.Exports;

/// <summary>
/// A section of an aggregate file: fixed text, or the parts that frames wrote under one name, in the order of the frames.
/// </summary>
public sealed record AggregateSection
{
    private AggregateSection(string text, string? part, string between, string after, bool areFiles)
    {
        Text = text;
        Part = part;
        Between = between;
        After = after;
        AreFiles = areFiles;
    }

    /// <summary>The fixed text; empty for parts.</summary>
    public string Text { get; }

    /// <summary>Name of the parts; null for fixed text.</summary>
    public string? Part { get; }

    /// <summary>Separator between parts.</summary>
    public string Between { get; }

    /// <summary>Text after each part.</summary>
    public string After { get; }

    /// <summary>Whether the parts are names of staged files, whose content is inserted.</summary>
    public bool AreFiles { get; }

    /// <summary>Writes a file around the content of staged files; null if the section is written part by part.</summary>
    public Action<Stream, IEnumerable<byte[]>>? WriteContainer { get; private init; }

    /// <summary>Writes what follows from all parts; null if the section is written part by part.</summary>
    public Action<TextWriter, IEnumerable<string>>? WriteSummary { get; private init; }

    /// <summary>Writes bytes that follow from all parts; null if the section is written part by part.</summary>
    public Action<Stream, IEnumerable<string>>? WriteBinary { get; private init; }

    /// <summary>A fixed text.</summary>
    public static AggregateSection Literal(string text) => new(text, null, "", "", false);

    /// <summary>Parts as lines.</summary>
    public static AggregateSection Lines(string part) => new("", part, "", "\n", false);

    /// <summary>Parts with a separator.</summary>
    public static AggregateSection Joined(string part, string between) => new("", part, between, "", false);

    /// <summary>The content of staged files, concatenated.</summary>
    public static AggregateSection Files(string part) => new("", part, "", "", true);

    /// <summary>The content of staged files in a container with an index, which is written when all of them are known.</summary>
    /// <param name="part">Name of the parts.</param>
    /// <param name="write">Writes the container; it gets the files one after another, so that it can hold one at a time.</param>
    public static AggregateSection Container(string part, Action<Stream, IEnumerable<byte[]>> write) =>
        new("", part, "", "", true) { WriteContainer = write };

    /// <summary>A text that follows from all parts, such as their number.</summary>
    /// <param name="part">Name of the parts.</param>
    /// <param name="write">Writes the text; it gets the parts in the order of the frames, so that it can hold one at a time.</param>
    public static AggregateSection Summary(string part, Action<TextWriter, IEnumerable<string>> write) =>
        new("", part, "", "", false) { WriteSummary = write };

    /// <summary>Bytes that follow from all parts, such as an image.</summary>
    /// <param name="part">Name of the parts.</param>
    /// <param name="write">Writes the bytes; it gets the parts in the order of the frames, so that it can hold one at a time.</param>
    public static AggregateSection Binary(string part, Action<Stream, IEnumerable<string>> write) =>
        new("", part, "", "", false) { WriteBinary = write };
}
