namespace Harvester.Tapes;

/// <summary>The first difference between a tape and the mod that plays it.</summary>
/// <param name="Tick">Number of the tick, from 1; 0 before the first.</param>
/// <param name="Call">Number of the call or grab within the whole tape, from 1.</param>
/// <param name="Expected">What the tape has.</param>
/// <param name="Got">What the mod did.</param>
public sealed record TapeDifference(int Tick, long Call, string Expected, string Got);
