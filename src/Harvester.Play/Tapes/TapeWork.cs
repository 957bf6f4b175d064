namespace Harvester.Play.Tapes;

/// <summary>The script asked whether work on another thread was done.</summary>
/// <param name="What">Name of the work.</param>
/// <param name="IsDone">The answer.</param>
public sealed record TapeWork(string What, bool IsDone) : TapeEntry;
