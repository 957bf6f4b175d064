namespace Harvester.Datasets.Diagnosis;

/// <summary>A line of a log, or a statement of session.json.</summary>
/// <param name="File">Name of the file, without its folder.</param>
/// <param name="Number">Line number, from 1; null if the file is not read by lines.</param>
/// <param name="Text">The text of the line.</param>
public sealed record LogLine(string File, int? Number, string Text)
{
    /// <summary>The place and the text.</summary>
    public override string ToString() => Number is { } number ? $"{File} line {number}: {Text}" : $"{File}: {Text}";
}
