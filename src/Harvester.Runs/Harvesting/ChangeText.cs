using System.Globalization;
using System.Text.RegularExpressions;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Harvesting;

/// <summary>Reads changes as they are written on the command line.</summary>
public static partial class ChangeText
{
    /// <summary>What the text may be, for messages.</summary>
    public const string Form =
        "MOMENT: CHANGE, where MOMENT is 'frame N', a game time as '12.5s' or 'at EVENT', and CHANGE is 'ID brakes A', "
        + "'ID brakes A for S', 'ID drives V', 'without ID' or 'weather NAME'; ID is the number of an object in the labels, an actor "
        + "of the scenario or 'ego', EVENT an event of the scenario, A is in m/s², S in seconds, V in m/s";

    /// <summary>Tyres brake no harder, m/s².</summary>
    private const double MaxDeceleration = 9;
    private const double MaxSpeed = 60;
    private const double MaxSeconds = 1e6;
    private const int Longest = 200;

    /// <summary>Reads the changes of one run, which are separated by semicolons. An underscore is a space.</summary>
    /// <returns>The changes; null if the text is not of this form.</returns>
    public static IReadOnlyList<TimedChange>? Read(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        if (text.Length > Longest)
        {
            return null;
        }

        TimedChange?[] changes = [.. text.Replace('_', ' ').Split(';').Select(part => ReadOne(part.Trim(' ')))];
        List<TimedChange> read = [.. changes.OfType<TimedChange>()];
        return read.Count == changes.Length ? read : null;
    }

    private static TimedChange? ReadOne(string text)
    {
        Match match = Pattern().Match(text);
        if (!match.Success)
        {
            return null;
        }

        int? id = Whole(match.Groups["number"]);
        WorldChange? change = ChangeOf(match);
        if (change is null || (match.Groups["number"].Success && id is null))
        {
            return null;
        }

        int? frame = Whole(match.Groups["frame"]);
        double? seconds = Number(match.Groups["time"], MaxSeconds);
        string? begun = match.Groups["event"] is { Success: true, Value: var name } ? name : null;
        return frame is null && seconds is null && begun is null
            ? null
            : new TimedChange(text, change)
            {
                Frame = frame,
                Seconds = seconds,
                Event = begun,
                Id = id,
                Actor = match.Groups["actor"] is { Success: true, Value: var actor } ? actor : null,
            };
    }

    private static WorldChange? ChangeOf(Match match)
    {
        if (match.Groups["weather"] is { Success: true, Value: var weather })
        {
            return WeatherNames.All.Contains(weather) ? new WorldChange(WorldChangeKind.Weather) { Weather = weather } : null;
        }

        if (match.Groups["without"].Success)
        {
            return new WorldChange(WorldChangeKind.Remove);
        }

        bool brakes = match.Groups["verb"].Value == "brakes";
        double? value = Number(match.Groups["value"], brakes ? MaxDeceleration : MaxSpeed);
        double? seconds = Number(match.Groups["for"], MaxSeconds);
        bool isWhole = value > 0 && (seconds is not null || !match.Groups["for"].Success) && (brakes || !match.Groups["for"].Success);
        return isWhole
            ? new WorldChange(brakes ? WorldChangeKind.Brake : WorldChangeKind.Drive) { Value = value!.Value, Seconds = seconds }
            : null;
    }

    private static int? Whole(Group group) =>
        group.Success && int.TryParse(group.Value, NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : null;

    private static double? Number(Group group, double most) =>
        group.Success
        && double.TryParse(group.Value, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double number)
        && number <= most
            ? number
            : null;

    [GeneratedRegex(
        @"^(?:frame (?<frame>\d+)|(?<time>[\d.]+) ?s|at (?<event>[A-Za-z0-9][A-Za-z0-9-]*)): "
            + @"(?:without (?<without>(?<number>\d+)|(?!ego\z)(?<actor>[A-Za-z][A-Za-z0-9-]*))|weather (?<weather>\w+)"
            + @"|(?:ego|(?<number>\d+)|(?<actor>[A-Za-z][A-Za-z0-9-]*)) (?<verb>brakes|drives) (?<value>[\d.]+)"
            + @"(?: for (?<for>[\d.]+) ?s?)?)\z",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        matchTimeoutMilliseconds: 1000
    )]
    private static partial Regex Pattern();
}
