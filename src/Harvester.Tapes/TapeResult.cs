namespace Harvester.Tapes;

/// <summary>The result of playing a tape.</summary>
/// <param name="Ticks">Ticks played to their end.</param>
/// <param name="Calls">Calls and grabs that were the same.</param>
/// <param name="IsInterrupted">Whether the recording was interrupted: the tape has no end, and its last event is not compared.</param>
/// <param name="RecordedBy">Version of the mod that recorded it.</param>
/// <param name="Difference">The first difference; null if there is none.</param>
public sealed record TapeResult(int Ticks, long Calls, bool IsInterrupted, string RecordedBy, TapeDifference? Difference);
