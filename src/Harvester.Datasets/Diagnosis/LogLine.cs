namespace Harvester.Datasets.Diagnosis;

/// <summary>A line of a log, or what a session says.</summary>
/// <param name="File">Name of the file, without its folder.</param>
/// <param name="Number">Number of the line, from 1; null where lines mean nothing.</param>
/// <param name="Text">What it says.</param>
public sealed record LogLine(string File, int? Number, string Text)
{
    /// <summary>Where it stands and what it says.</summary>
    public override string ToString() => Number is { } number ? $"{File} line {number}: {Text}" : $"{File}: {Text}";
}
