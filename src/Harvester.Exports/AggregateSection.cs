namespace Harvester.Exports;

/// <summary>
/// A section of an aggregate file: fixed text, or what follows from the parts that frames wrote under one name, in the order of the frames.
/// </summary>
public abstract class AggregateSection
{
    /// <summary>A fixed text.</summary>
    public static AggregateSection Literal(string text) => new LiteralSection(text);

    /// <summary>Parts as lines.</summary>
    public static AggregateSection Lines(string part) => new PartsSection(part, "", "\n");

    /// <summary>Parts with a separator.</summary>
    public static AggregateSection Joined(string part, string between) => new PartsSection(part, between, "");

    /// <summary>The content of staged files, concatenated.</summary>
    /// <param name="part">Name of the parts, which are names of staged files.</param>
    public static AggregateSection Files(string part) => new FilesSection(part);

    /// <summary>The content of staged files in a container with an index, which is written when all of them are known.</summary>
    /// <param name="part">Name of the parts, which are names of staged files.</param>
    /// <param name="write">Writes the container; it gets the files one after another, so that it can hold one at a time.</param>
    public static AggregateSection Container(string part, Action<Stream, IEnumerable<byte[]>> write) => new ContainerSection(part, write);

    /// <summary>A file that another program makes of staged files.</summary>
    /// <param name="part">Name of the parts, which are names of staged files.</param>
    /// <param name="write">
    /// Runs the program; it gets the path to write to and those of the staged files, in the order of the frames.
    /// </param>
    internal static AggregateSection MadeBy(string part, Action<string, IEnumerable<string>> write) => new ProgramSection(part, write);

    /// <summary>A text that follows from all parts, such as their number.</summary>
    /// <param name="part">Name of the parts.</param>
    /// <param name="write">Writes the text; it gets the parts in the order of the frames, so that it can hold one at a time.</param>
    public static AggregateSection Summary(string part, Action<TextWriter, IEnumerable<string>> write) => new SummarySection(part, write);

    /// <summary>Bytes that follow from all parts, such as an image.</summary>
    /// <param name="part">Name of the parts.</param>
    /// <param name="write">Writes the bytes; it gets the parts in the order of the frames, so that it can hold one at a time.</param>
    public static AggregateSection Binary(string part, Action<Stream, IEnumerable<string>> write) => new BinarySection(part, write);

    /// <summary>Writes the section.</summary>
    internal abstract void Write(IAggregateOutput output);
}
