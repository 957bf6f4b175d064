namespace Harvester.Driving.Bridge;

/// <summary>
/// Reports that the client has disconnected or been replaced. Only the bridge creates it; a client cannot send it. The client's requests
/// are void, and no message of that client follows.
/// </summary>
public sealed record ClientGoneMessage : ClientMessage;
