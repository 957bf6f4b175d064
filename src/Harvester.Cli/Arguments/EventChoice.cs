using System.CommandLine;
using System.Globalization;
using Harvester.Runs.Faults;
using Harvester.Sessions.Events;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Arguments;

/// <summary>The options about events.</summary>
internal sealed class EventChoice
{
    private static readonly string KindNames = string.Join(", ", Enum.GetValues<EventKind>().Select(JsonName.Of));

    private Option<bool> Events { get; } =
        new("--events")
        {
            Description = "Find near misses, collisions, cut-ins, red lights run and more at every tick, and list them in events.jsonl",
        };

    private Option<double?> KeepAround { get; } =
        new("--keep-around")
        {
            Description = "Write only the frames from so long before an event to so long after it; 1s to 60s",
            HelpName = "S",
            CustomParser = result =>
            {
                string text = result.Tokens[0].Value;
                double? seconds = double.TryParse(
                    text.EndsWith('s') ? text[..^1] : text,
                    NumberStyles.AllowDecimalPoint,
                    CultureInfo.InvariantCulture,
                    out double number
                )
                    ? number
                    : null;
                if (seconds is not (>= EventOptions.MinKeepSeconds and <= EventOptions.MaxKeepSeconds))
                {
                    result.AddError($"--keep-around must be a time from 1s to 60s, such as 5s, not '{text}'.");
                }

                return seconds;
            },
        };

    private Option<string?> KeepKinds { get; } =
        new("--keep-kinds") { Description = $"Kinds of events that keep frames: a list of {KindNames} [default: all]", HelpName = "LIST" };

    public void AddTo(Command command)
    {
        command.Add(Events);
        command.Add(KeepAround);
        command.Add(KeepKinds);
    }

    /// <summary>The options; null if no events are to be found.</summary>
    /// <exception cref="UsageException">An option needs another one, or a kind is unknown.</exception>
    public EventOptions? Parse(ParseResult parsed)
    {
        double? around = parsed.GetValue(KeepAround);
        string? kinds = parsed.GetValue(KeepKinds);
        if (!parsed.GetValue(Events) && around is not null)
        {
            throw new UsageException("--keep-around needs --events.");
        }

        if (around is null && kinds is not null)
        {
            throw new UsageException("--keep-kinds needs --keep-around.");
        }

        var all = new EventOptions();
        return parsed.GetValue(Events)
            ? all with
            {
                KeepAroundSeconds = around,
                KeepKinds = kinds is null ? all.KeepKinds : KindsOf(kinds),
            }
            : null;
    }

    private static List<EventKind> KindsOf(string list)
    {
        string[] names = list.Split(',', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
        if (
            names.Length == 0
            || names.FirstOrDefault(name => !Enum.GetValues<EventKind>().Any(kind => JsonName.Of(kind) == name)) is not null
        )
        {
            throw new UsageException($"--keep-kinds must be a list of {KindNames}, not '{list}'.");
        }

        return [.. Enum.GetValues<EventKind>().Where(kind => names.Contains(JsonName.Of(kind)))];
    }
}
