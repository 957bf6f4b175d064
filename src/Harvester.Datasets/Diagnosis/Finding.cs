namespace Harvester.Datasets.Diagnosis;

/// <summary>A problem with its likely cause.</summary>
/// <param name="Cause">The cause, one sentence.</param>
/// <param name="Advice">What to do about it, one or two sentences.</param>
/// <param name="Evidence">The last line that shows it; null if it follows from something missing.</param>
/// <param name="Count">Number of occurrences, at least 1.</param>
public sealed record Finding(string Cause, string Advice, LogLine? Evidence = null, int Count = 1);
