namespace Harvester.Tapes;

/// <summary>The tape has no answer, because it ended or differed; the mod's features stop.</summary>
internal sealed class TapeStoppedException() : Exception("The tape has no further answers.");
