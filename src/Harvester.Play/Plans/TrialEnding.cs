namespace Harvester.Play.Plans;

/// <summary>How an attempt at a trial ended.</summary>
/// <param name="Frames">Number of frames.</param>
/// <param name="Reason">Why it failed; null if it did not.</param>
/// <param name="IsSpaceLow">Whether the disk had too little space, which is no fault of the trial.</param>
public sealed record TrialEnding(int Frames, string? Reason, bool IsSpaceLow = false);
