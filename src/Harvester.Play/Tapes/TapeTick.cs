namespace Harvester.Play.Tapes;

/// <summary>A tick of the game: the entries up to the next tick or key belong to it.</summary>
public sealed record TapeTick : TapeEntry;
