namespace Harvester.Capture.Events;

/// <summary>The road users at one reading of the game.</summary>
/// <param name="Seconds">The game's time, seconds.</param>
/// <param name="Ego">The ego.</param>
/// <param name="Others">The others, in the order of their handles.</param>
internal sealed record SceneReading(double Seconds, RoadUser Ego, IReadOnlyList<RoadUser> Others);
