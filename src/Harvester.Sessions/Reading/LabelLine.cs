using Harvester.Sessions.Labels;

namespace Harvester.Sessions.Reading;

/// <summary>A line of labels.jsonl: a label, or why it cannot be read.</summary>
/// <param name="Number">Number of the line in its file, from 1.</param>
/// <param name="Text">The text of the line.</param>
/// <param name="Label">The label; null if the line cannot be read.</param>
/// <param name="Problem">Why the line cannot be read; null if it can.</param>
public sealed record LabelLine(int Number, string Text, FrameLabel? Label, string? Problem)
{
    /// <summary>What a check of the line's fields found; empty if none was asked for.</summary>
    internal IReadOnlyList<string> Findings { get; init; } = [];
}
