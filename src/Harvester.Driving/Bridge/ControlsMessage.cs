using Harvester.Capture.Ports;

namespace Harvester.Driving.Bridge;

/// <summary>Steering, throttle and brake. They hold until the next ones, or until the client has been silent too long.</summary>
/// <param name="Controls">Steering, throttle and brake.</param>
/// <param name="Frame">Number of the frame that they answer; null if the client does not say.</param>
public sealed record ControlsMessage(DrivingControls Controls, long? Frame) : ClientMessage;
