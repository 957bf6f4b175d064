using System.CommandLine;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Driving;
using Harvester.Runs.Faults;
using Harvester.Sessions.Events;

namespace Harvester.Cli.Arguments;

/// <summary>--record, --record-every, --record-events and --min-free.</summary>
internal sealed class RecordOptions
{
    /// <summary>Controls are decided in this period, seconds of game time; frames are recorded where they are.</summary>
    private const double PeriodSeconds = 0.1;
    private const double Rounding = 1e-9;

    private readonly Option<string?> _folder;
    private readonly Option<double> _every = ValueParsers.Number(
        "--record-every",
        "S",
        "Game time from one recorded frame to the next, seconds",
        IsPeriod,
        "a multiple of 0.1, at most 60"
    );

    private readonly Option<bool> _events = new("--record-events")
    {
        Description =
            "Find near misses, collisions, cut-ins, red lights run and more at every tick, and list them in events.jsonl of the recording",
    };

    private readonly Option<long?> _minFree = MinFreeOption.Create();

    /// <summary>Creates the options.</summary>
    /// <param name="what">What is recorded: the words after "Record".</param>
    public RecordOptions(string what)
    {
        _folder = new Option<string?>("--record") { Description = $"Record {what}", HelpName = "DIR" };
        _every.DefaultValueFactory = _ => 2 * PeriodSeconds;
    }

    /// <summary>The options.</summary>
    public IEnumerable<Option> All => [_folder, _every, _events, _minFree];

    /// <summary>The folder of the recording; null if nothing is recorded.</summary>
    public string? FolderOf(ParseResult parsed) => parsed.GetValue(_folder);

    /// <summary>The plan that the options describe; null if nothing is recorded.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="size">Size of the images, pixels.</param>
    /// <param name="isNumbered">Whether there may be several drives, each with a session.</param>
    /// <param name="settings">Settings of the drive for session.json.</param>
    /// <exception cref="UsageException">Nothing is recorded, but another of the options is given.</exception>
    public RecordPlan? Parse(ParseResult parsed, ImageSize size, bool isNumbered, IReadOnlyList<KeyValuePair<string, string>> settings)
    {
        if (FolderOf(parsed) is { } folder)
        {
            return new RecordPlan(folder, parsed.GetValue(_every), size)
            {
                IsNumbered = isNumbered,
                MinFreeBytes = MinFreeOption.BytesIn(parsed, _minFree),
                Settings = settings,
                Events = parsed.GetValue(_events) ? new EventOptions() : null,
            };
        }

        return
            new Option[] { _every, _events, _minFree }.FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false })
                is { } alone
            ? throw new UsageException($"{alone.Name} needs {_folder.Name}.")
            : null;
    }

    private static bool IsPeriod(double seconds) =>
        seconds is > 0 and <= 60
        && Math.Abs(Math.Round(seconds / PeriodSeconds) - (seconds / PeriodSeconds)) < Rounding
        && seconds > PeriodSeconds / 2;
}
