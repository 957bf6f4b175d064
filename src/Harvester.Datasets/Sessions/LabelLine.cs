using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Sessions;

/// <summary>A line of labels.jsonl: a label, or what is wrong with it.</summary>
/// <param name="Number">Number of the line in its file, from 1.</param>
/// <param name="Text">The line as it stands there.</param>
/// <param name="Label">The label; null when the line cannot be read.</param>
/// <param name="Problem">Why it cannot be read; null when it can.</param>
public sealed record LabelLine(int Number, string Text, FrameLabel? Label, string? Problem);
