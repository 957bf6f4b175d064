namespace Harvester.Driving.Bridge;

/// <summary>A message of a client.</summary>
public abstract record ClientMessage;
