namespace Harvester.Driving.Bridge;

/// <summary>Requests a frame now, in addition to those sent at the bridge's rate.</summary>
/// <param name="HasPicture">Whether the frame comes with an image.</param>
public sealed record RequestFrameMessage(bool HasPicture = true) : ClientMessage;
