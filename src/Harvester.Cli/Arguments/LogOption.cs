using System.CommandLine;
using System.CommandLine.Parsing;
using Harvester.Capture.Labelling;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;

namespace Harvester.Cli.Arguments;

/// <summary>The option that replays an imported log.</summary>
internal sealed class LogOption
{
    private const string Name = "--log";

    /// <summary>The options about roads and traffic, which a log has itself.</summary>
    private static readonly string[] OfTraffic =
    [
        "--roads",
        "--near",
        "--places",
        "--props",
        "--wander",
        "--lane-changes",
        "--traffic",
        "--pedestrians",
        "--parked",
        "--varied-roads",
    ];

    private readonly Option<DirectoryInfo?> _folder = new(Name)
    {
        Description = "Replay the traffic of this imported log on its roads, as its car saw it; see log import",
        HelpName = "DIR",
    };

    /// <summary>Adds the option to a command.</summary>
    public void AddTo(Command command) => command.Options.Add(_folder);

    /// <summary>The plan with the log's roads, traffic and, unless --frames is given, as many frames as it lasts.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="plan">The plan without the log.</param>
    /// <exception cref="UsageException">An option contradicts it, or it is shorter than the frames.</exception>
    public HarvestPlan AppliedTo(ParseResult parsed, HarvestPlan plan)
    {
        if (parsed.GetValue(_folder) is not { } folder)
        {
            return plan;
        }

        if (OfTraffic.FirstOrDefault(name => IsGiven(parsed, name)) is { } contradicted)
        {
            throw new UsageException($"{contradicted} cannot be used with {Name}, which has its own roads and traffic.");
        }

        string log = Path.TrimEndingDirectorySeparator(folder.FullName);
        double seconds = LoggedTraffic.SecondsOf(log);
        int lasting = Math.Max(1, (int)Math.Min(int.MaxValue, Math.Floor(seconds * plan.Options.RateHz)));
        if (IsGiven(parsed, "--frames") && plan.Frames > lasting)
        {
            throw new UsageException(
                FormattableString.Invariant(
                    $"The log lasts {seconds:0.0} s, which are {lasting} frames at {plan.Options.RateHz} Hz, not {plan.Frames}. Lower "
                ) + "--frames, or omit it."
            );
        }

        int frames = IsGiven(parsed, "--frames") ? plan.Frames : lasting;
        return plan with
        {
            Log = log,
            Roads = LoggedTraffic.RoadsOf(log),
            Frames = frames,
            Options = plan.Options with { MaxFrames = frames, Places = new PlaceSequence(frames, 1) },
            Variety = plan.Variety with { TrafficDensity = 0, ParkedDensity = 0, PedestrianDensity = 0, Wander = 0, LaneChanges = 0 },
        };
    }

    private static bool IsGiven(ParseResult parsed, string name) => parsed.GetResult(name) is OptionResult { Implicit: false };
}
