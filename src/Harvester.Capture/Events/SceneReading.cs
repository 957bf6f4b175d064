namespace Harvester.Capture.Events;

/// <summary>The road users at one reading of the game.</summary>
/// <param name="Seconds">The game's time, seconds.</param>
/// <param name="Ego">The ego.</param>
/// <param name="Others">The others, in the order of their handles.</param>
/// <param name="Roads">The roads around them; null if they are not known.</param>
internal sealed record SceneReading(double Seconds, RoadUser Ego, IReadOnlyList<RoadUser> Others, RoadScene? Roads)
{
    /// <summary>The ego and the other vehicles that drive themselves, which trailers do not.</summary>
    public IEnumerable<RoadUser> Driven => new[] { Ego }.Concat(Others.Where(static user => user.IsDriven));
}
