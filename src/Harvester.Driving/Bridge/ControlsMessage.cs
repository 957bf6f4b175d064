using Harvester.Capture.Ports;

namespace Harvester.Driving.Bridge;

/// <summary>Wheel and pedals, held until the next ones or until the client has been silent too long.</summary>
/// <param name="Controls">What to do.</param>
/// <param name="Frame">Number of the frame that they answer; null when the client does not say.</param>
public sealed record ControlsMessage(DrivingControls Controls, long? Frame) : ClientMessage;
