namespace Harvester.Play.Plans;

/// <summary>How an attempt at a trial ended.</summary>
/// <param name="Frames">Number of frames.</param>
/// <param name="Reason">Why it failed; null if it did not.</param>
public sealed record TrialEnding(int Frames, string? Reason);
