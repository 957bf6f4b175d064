namespace Harvester.Driving.Bridge;

/// <summary>Requests a frame now, in addition to those sent at the bridge's rate.</summary>
public sealed record RequestFrameMessage : ClientMessage;
