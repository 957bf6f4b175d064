namespace Harvester.Play.Tapes;

/// <summary>A reading of the real clock.</summary>
/// <param name="Steps">Steps of 100 ns.</param>
public sealed record TapeClock(long Steps) : TapeEntry
{
    /// <summary>Steps in a millisecond.</summary>
    public const double StepsPerMillisecond = 10_000;

    /// <summary>The time, milliseconds.</summary>
    public double Milliseconds => Steps / StepsPerMillisecond;
}
