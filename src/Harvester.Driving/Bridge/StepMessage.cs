namespace Harvester.Driving.Bridge;

/// <summary>Lets a paused world go on for so long, then stops it and sends a frame: a learner's lock-step.</summary>
/// <param name="Seconds">Game time, more than 0 and at most 10 seconds.</param>
public sealed record StepMessage(double Seconds) : ClientMessage;
