namespace Harvester.Driving.Bridge;

/// <summary>
/// The thirteen indicators as a network estimated them from the image; the game's side then drives by them. Figure 23 of the thesis.
/// </summary>
/// <param name="Values">Thirteen numbers in the order of docs/bridge.md, metres and radians as a road of TORCS would give them.</param>
/// <param name="Frame">Number of the frame that they answer; null if the client does not say.</param>
public sealed record IndicatorsMessage(IReadOnlyList<double> Values, long? Frame) : ClientMessage;
