namespace Harvester.Driving.Bridge;

/// <summary>Pauses or resumes the game.</summary>
/// <param name="IsPaused">Whether the game is to be paused.</param>
public sealed record PauseMessage(bool IsPaused) : ClientMessage;
