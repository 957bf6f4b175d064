namespace Harvester.Driving.Bridge;

/// <summary>
/// The bridge's own word, which no client can say: the client is gone, or another has taken its place. What it asked for is void; nothing
/// that it said comes after this.
/// </summary>
public sealed record ClientGoneMessage : ClientMessage;
