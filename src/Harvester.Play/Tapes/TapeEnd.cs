namespace Harvester.Play.Tapes;

/// <summary>The end of a recording that was not interrupted.</summary>
/// <param name="Reason">Why it ended.</param>
public sealed record TapeEnd(string Reason) : TapeEntry;
