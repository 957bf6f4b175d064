namespace Harvester.Capture.Surveys;

/// <summary>How long a survey of paint takes in the game.</summary>
public static class SurveyDuration
{
    /// <summary>
    /// Seconds for a picture before any is taken: half a second until the ground is loaded, half a second of standing, half a second for
    /// hiding, settling and grabbing, and one for 24,000 rays of 10 µs in 4 ms of each tick, at 60 ticks a second.
    /// </summary>
    public const double UsualSecondsPerPicture = 2.5;

    /// <summary>The time in words, such as "2 h 5 min".</summary>
    /// <param name="pictures">Number of pictures, 0 or more.</param>
    /// <param name="secondsPerPicture">Seconds for one, 0 or more.</param>
    public static string Text(int pictures, double secondsPerPicture)
    {
        var time = TimeSpan.FromMinutes(Math.Ceiling(pictures * secondsPerPicture / 60));
        int hours = (int)time.TotalHours;
        return hours > 0
            ? FormattableString.Invariant($"{hours} h {time.Minutes} min")
            : FormattableString.Invariant($"{time.Minutes} min");
    }
}
