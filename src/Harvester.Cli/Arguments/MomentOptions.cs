using System.CommandLine;
using System.Globalization;
using Harvester.Runs.Faults;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Arguments;

/// <summary>The options that set weather, time of day and date of a simulated world.</summary>
internal sealed class MomentOptions
{
    /// <summary>A year without a leap day.</summary>
    private const int CommonYear = 2023;
    private static readonly TimeSpan Noon = TimeSpan.FromHours(12);

    private readonly Option<string> _weather = new("--weather")
    {
        Description = "Weather: " + string.Join(", ", WeatherNames.All),
        HelpName = "W",
        DefaultValueFactory = _ => "clear",
    };

    private readonly Option<TimeSpan?> _time = ValueParsers.Optional<TimeSpan>(
        "--time",
        "HH:MM",
        "Time of day at the start [default: 12:00]",
        ParseTime,
        "a time of day, e.g. 18:30"
    );

    private readonly Option<int?> _date = ValueParsers.Optional<int>(
        "--date",
        "MM-DD",
        "Day of the year, for the height of the sun [default: 05-01]",
        ParseDate,
        "a day of the year, e.g. 12-21"
    );

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        command.Options.Add(_weather);
        command.Options.Add(_time);
        command.Options.Add(_date);
    }

    /// <summary>The weather.</summary>
    /// <exception cref="UsageException">The game has no such weather.</exception>
    public string Weather(ParseResult parsed)
    {
        string weather = parsed.GetRequiredValue(_weather);
        return WeatherNames.Find(weather)
            ?? throw new UsageException($"--weather takes one of {string.Join(", ", WeatherNames.All)}, not '{weather}'.");
    }

    /// <summary>The time of day at the start.</summary>
    public TimeSpan TimeOfDay(ParseResult parsed) => parsed.GetValue(_time) ?? Noon;

    /// <summary>The day of the year, from 1.</summary>
    public int DayOfYear(ParseResult parsed) => parsed.GetValue(_date) ?? new SimulationOptions().DayOfYear;

    private static TimeSpan? ParseTime(string text) =>
        TimeSpan.TryParseExact(text, [@"hh\:mm", @"h\:mm"], CultureInfo.InvariantCulture, out TimeSpan time) ? time : null;

    private static int? ParseDate(string text) =>
        DateTime.TryParseExact($"{CommonYear}-{text}", "yyyy-MM-dd", CultureInfo.InvariantCulture, DateTimeStyles.None, out DateTime date)
            ? date.DayOfYear
            : null;
}
