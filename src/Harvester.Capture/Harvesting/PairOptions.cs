using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// The further pictures of each moment: in every weather at every hour, and each of them, the frame's image too, also without objects.
/// </summary>
/// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
public sealed record PairOptions
{
    /// <summary>Maximum number of further pictures of a moment.</summary>
    public const int MaxPictures = 10_000;

    private const int HoursOfDay = 24;

    /// <summary>Names of the weathers, each once; empty for that of the moment.</summary>
    public IReadOnlyList<string> Weathers
    {
        get;
        init =>
            field =
                value.All(WeatherNames.IsKnown) && IsEachOnce(value)
                    ? value
                    : throw new ArgumentOutOfRangeException(nameof(Weathers), "Weathers must be names of the game, each once.");
    } = [];

    /// <summary>Hours of the day, 0 to 23, each once; empty for the time of the moment.</summary>
    public IReadOnlyList<int> Hours
    {
        get;
        init =>
            field =
                value.All(hour => hour is >= 0 and < HoursOfDay) && IsEachOnce(value)
                    ? value
                    : throw new ArgumentOutOfRangeException(nameof(Hours), "Hours must be from 0 to 23, each once.");
    } = [];

    /// <summary>Objects without which each picture is taken once more; a moment without such objects has no such pictures.</summary>
    public IReadOnlyList<HiddenChoice> Without
    {
        get;
        init =>
            field = IsEachOnce(value.Select(choice => choice.Name))
                ? value
                : throw new ArgumentOutOfRangeException(nameof(Without), "Each choice of objects must be given once.");
    } = [];

    /// <summary>Time limit of a picture, ticks, 10 to 10,000: one that still changes then is dropped.</summary>
    public int MaxTicks
    {
        get;
        init => field = OptionCheck.InRange(value, 10, 10_000, nameof(MaxTicks));
    } = 240;

    /// <summary>
    /// Whether every picture takes the time limit, so that the game's ticks depend on the options only. For a game whose course is the same
    /// in every run, which can be divided into shards and resumed.
    /// </summary>
    public bool TakesAllTicks { get; init; }

    /// <summary>Whether there is any further picture.</summary>
    public bool IsAny => Conditions > 0 || Without.Count > 0;

    /// <summary>Number of combinations of weather and hour.</summary>
    public int Conditions => Weathers.Count + Hours.Count == 0 ? 0 : Math.Max(1, Weathers.Count) * Math.Max(1, Hours.Count);

    /// <summary>Greatest number of further pictures of a moment.</summary>
    public int Pictures => Conditions + (Without.Count * (1 + Conditions));

    private static bool IsEachOnce<T>(IEnumerable<T> values)
    {
        List<T> all = [.. values];
        return all.Distinct().Count() == all.Count;
    }
}
