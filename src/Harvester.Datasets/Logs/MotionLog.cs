namespace Harvester.Datasets.Logs;

/// <summary>A log of traffic: what moved in a stretch of time, the map, and the lights.</summary>
/// <param name="Id">Its name.</param>
/// <param name="Times">Times of its steps, seconds, ascending.</param>
/// <param name="Tracks">What moved; each has as many states as there are steps.</param>
/// <param name="Ego">Index of the track of the car that recorded it.</param>
/// <param name="Features">The map.</param>
/// <param name="Signals">The lights at each step.</param>
internal sealed record MotionLog(
    string Id,
    IReadOnlyList<double> Times,
    IReadOnlyList<LogTrack> Tracks,
    int Ego,
    IReadOnlyList<LogFeature> Features,
    IReadOnlyList<IReadOnlyList<LogSignal>> Signals
);
