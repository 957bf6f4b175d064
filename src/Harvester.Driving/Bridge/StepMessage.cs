namespace Harvester.Driving.Bridge;

/// <summary>Lets a paused game run for a time, then pauses it and sends a frame: the lock-step of a learner.</summary>
/// <param name="Seconds">Game time, more than 0 and at most 10 seconds.</param>
/// <param name="HasPicture">Whether the frame comes with an image.</param>
public sealed record StepMessage(double Seconds, bool HasPicture = true) : ClientMessage;
