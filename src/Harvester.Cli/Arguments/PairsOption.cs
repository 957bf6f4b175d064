using System.CommandLine;
using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Runs.Faults;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Arguments;

/// <summary>The options of harvester harvest for further pictures of each moment.</summary>
internal sealed class PairsOption
{
    /// <summary>What the options do, for the help.</summary>
    public const string Notes =
        "With --pair-weathers and --pair-hours, the frozen world of each frame is also photographed in every one of these weathers\n"
        + "at every one of these hours; with --pair-without, every picture of the moment, the frame's image included, also without\n"
        + "some objects:\n"
        + "  signs, vehicles, people, or a class such as car: all labelled objects of this kind\n"
        + "  nearest-sign, nearest-vehicle, nearest-person, nearest-car, ...: the nearest one\n"
        + "  17: the object with this id\n"
        + "The pictures are in the folder pairs; docs/pairs.md describes them, and harvester pairs exports them.";

    private const string All = "all";
    private const int HoursOfDay = 24;

    private readonly Option<string?> _weathers = new("--pair-weathers")
    {
        Description = "Also photograph each moment in these weathers, separated by commas, or all",
        HelpName = "W,W",
    };

    private readonly Option<string?> _hours = new("--pair-hours")
    {
        Description = "Also photograph each moment at these hours of the day, 0 to 23, separated by commas, or all",
        HelpName = "H,H",
    };

    private readonly Option<string?> _without = new("--pair-without")
    {
        Description = "Also take each picture of a moment without these objects, see below; one more picture for each entry",
        HelpName = "A,B",
    };

    private readonly Option<int> _ticks = ValueParsers.Integer(
        "--pair-ticks",
        "N",
        "Time limit for a further picture to stop changing, ticks (1/60 s)",
        10,
        10_000
    );

    public PairsOption() => _ticks.DefaultValueFactory = _ => new PairOptions().MaxTicks;

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        command.Options.Add(_weathers);
        command.Options.Add(_hours);
        command.Options.Add(_without);
        command.Options.Add(_ticks);
    }

    /// <summary>The further pictures.</summary>
    /// <exception cref="UsageException">A value is not valid.</exception>
    public PairOptions Parse(ParseResult parsed)
    {
        PairOptions options = new()
        {
            Weathers = [.. List("--pair-weathers", parsed.GetValue(_weathers), WeatherNames.All, Weather)],
            Hours = [.. List("--pair-hours", parsed.GetValue(_hours), [.. Enumerable.Range(0, HoursOfDay)], Hour)],
            Without = [.. List("--pair-without", parsed.GetValue(_without), [], Choice)],
            MaxTicks = parsed.GetValue(_ticks),
            TakesAllTicks = true,
        };
        return options.Pictures <= PairOptions.MaxPictures
            ? options
            : throw new UsageException(
                $"The --pair options ask for {options.Pictures} pictures of each frame, more than {PairOptions.MaxPictures}. "
                    + "Give fewer values."
            );
    }

    private static IEnumerable<T> List<T>(string option, string? text, IReadOnlyList<T> all, Func<string, T> parse)
    {
        if (text is null)
        {
            return [];
        }

        if (text.Equals(All, StringComparison.OrdinalIgnoreCase) && all.Count > 0)
        {
            return all;
        }

        string[] parts = [.. text.Split(',').Select(part => part.Trim())];
        return parts.GroupBy(part => part, StringComparer.OrdinalIgnoreCase).FirstOrDefault(group => group.Count() > 1) is { } twice
            ? throw new UsageException($"{option} has '{twice.Key}' twice.")
            : parts.Select(parse);
    }

    private static string Weather(string text) =>
        WeatherNames.Find(text)
        ?? throw new UsageException($"--pair-weathers takes {string.Join(", ", WeatherNames.All)}, or {All}, not '{text}'.");

    private static int Hour(string text) =>
        int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int hour)
        && hour < HoursOfDay
        && text == hour.ToString(CultureInfo.InvariantCulture)
            ? hour
            : throw new UsageException($"--pair-hours takes whole hours from 0 to 23, or {All}, not '{text}'.");

    private static HiddenChoice Choice(string text) =>
        HiddenChoice.Parse(text) ?? throw new UsageException($"--pair-without takes {HiddenChoice.Form}, not '{text}'.");
}
