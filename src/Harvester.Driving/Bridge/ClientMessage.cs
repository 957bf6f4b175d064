namespace Harvester.Driving.Bridge;

/// <summary>What the other side of a bridge asks for.</summary>
public abstract record ClientMessage;
