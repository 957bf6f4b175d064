namespace Harvester.Driving.Bridge;

/// <summary>Asks for a frame now, besides those that come at the bridge's rate.</summary>
public sealed record RequestFrameMessage : ClientMessage;
