namespace Harvester.Runs.Faults;

/// <summary>The game failed; the message is one line.</summary>
public sealed class GameFaultException(string message) : Exception(message);
