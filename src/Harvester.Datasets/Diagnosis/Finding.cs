namespace Harvester.Datasets.Diagnosis;

/// <summary>A problem with its likely cause.</summary>
/// <param name="Cause">What is the matter, one sentence.</param>
/// <param name="Advice">What to do about it, one sentence or two.</param>
/// <param name="Evidence">The last line that shows it; null when it shows by something that is missing.</param>
/// <param name="Count">How often it was seen, at least 1.</param>
public sealed record Finding(string Cause, string Advice, LogLine? Evidence = null, int Count = 1);
