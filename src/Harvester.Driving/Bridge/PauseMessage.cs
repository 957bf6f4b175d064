namespace Harvester.Driving.Bridge;

/// <summary>Stops the world or lets it go on.</summary>
/// <param name="IsPaused">Whether it is to stand still.</param>
public sealed record PauseMessage(bool IsPaused) : ClientMessage;
