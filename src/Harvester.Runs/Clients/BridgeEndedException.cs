namespace Harvester.Runs.Clients;

/// <summary>The game has closed its bridge, as it does when a drive is over.</summary>
public sealed class BridgeEndedException() : IOException("The game has closed the bridge.");
