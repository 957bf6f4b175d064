namespace Harvester.Simulation.Settings;

/// <summary>Recorded traffic, which a world replays by its poses instead of having traffic of its own.</summary>
/// <param name="Times">Times of the steps, seconds from the start of the world, ascending. Before the first the world stands at it, after
/// the last at that.</param>
/// <param name="Tracks">What moves, as many states each as there are steps.</param>
/// <param name="Ego">Index of the track of the car that carries the camera.</param>
public sealed record TrafficReplay(IReadOnlyList<double> Times, IReadOnlyList<ReplayTrack> Tracks, int Ego);
