namespace Harvester.Play.Tapes;

/// <summary>An entry of a tape.</summary>
public abstract record TapeEntry;
