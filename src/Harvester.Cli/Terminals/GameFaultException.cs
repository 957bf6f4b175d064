namespace Harvester.Cli.Terminals;

/// <summary>The game failed; the message is one line.</summary>
internal sealed class GameFaultException(string message) : Exception(message);
