using System.CommandLine;
using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Driving;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenarios;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Scenarios;

/// <summary>harvester scenario run: stages a scenario in the simulated game and harvests it.</summary>
internal sealed class ScenarioRunCommand
{
    private const string Notes =
        "With one seed the session is DIR; with --seeds each has a session of its own, DIR/SEED. A seed chooses the values of the\n"
        + "parameters, the town, unless --roads is given, and the place in it, unless --near is given. Where the scenario cannot happen,\n"
        + "the command says why, and the exit code is 2; with --seeds it goes on with the next one, and the exit code is 4.\n"
        + "scenario.json in the session has the values, the actors' handles and when each event began and ended. Labels have what\n"
        + "happened, whatever was intended.\n\n"
        + "With --change, DIR has the session base, and one more for each --change: change-01, change-02 and so on. All agree to the byte\n"
        + "up to the change (docs/counterfactuals.md). Several changes of one run are separated by semicolons:\n"
        + "  at cut: ego brakes 6            when the event cut begins, the ego brakes with 6 m/s2 to a stop and stands\n"
        + "  at cut: other brakes 3 for 8    the actor other brakes and stands, 8 s in all, instead of following its events\n"
        + "  frame 10: other drives 15       after frame 10, the actor aims for 15 m/s, and follows no further event\n"
        + "  2.5s: without other             from the game time 2.5 s on, the actor is gone\n"
        + "  frame 0: weather rain           it rains, and the road is slippery\n\n"
        + "Examples:\n"
        + "  harvester scenario run data/scenarios/cut-in-left.json --out out\n"
        + "  harvester scenario run data/scenarios/hard-braking-leader.json --seeds 1-20 --out braking --brake off\n"
        + "  harvester scenario run data/scenarios/cut-in-left.json --out otherwise --change \"at cut: ego brakes 6\"";

    private Option<string> Out { get; } =
        new("--out")
        {
            Description = "Folder to write to",
            HelpName = "DIR",
            Required = true,
        };
    private Option<bool> Overwrite { get; } = new("--overwrite") { Description = "Replace an existing session in the folder" };
    private Option<bool> Resume { get; } = new("--resume") { Description = "Continue an unfinished run of the same command, or start one" };
    private Option<int> Seed { get; } = WithDefault(ValueParsers.Integer("--seed", "N", "Seed", 0, int.MaxValue), 1);

    private Option<SeedRange?> Seeds { get; } =
        ValueParsers.Optional<SeedRange>(
            "--seeds",
            "A-B",
            "Run with each of these seeds instead of one",
            SeedRange.Parse,
            "two seeds, the smaller one first, at most 1000 in all, e.g. 701-720"
        );

    private Option<FileInfo?> Roads { get; } =
        new("--roads") { Description = "Road network, a file or folder [default: a town generated from the seed]", HelpName = "FILE" };

    private Option<Vector2D?> Near { get; } =
        ValueParsers.Point("--near", "X,Y", "Place at which the ego begins, metres [default: any that fits, chosen by the seed]");

    private Option<string> Brake { get; } =
        new("--brake")
        {
            Description = "Whether the ego's driver minds the actors: on, or off to drive on as if they were not there",
            HelpName = "on|off",
            DefaultValueFactory = _ => "on",
        };

    private Option<string[]> Change { get; } =
        new("--change")
        {
            Description = "Stage the scenario again with this changed: MOMENT: CHANGE, see below; repeatable, one run for each",
            HelpName = "CHANGE",
        };

    private Option<string> Crashes { get; } =
        new("--crashes")
        {
            Description = "Whether vehicles brake only as hard as tyres allow, and collide; with off they stop at once",
            HelpName = "on|off",
            DefaultValueFactory = _ => "on",
        };

    private Option<ImageSize> Size { get; } = WithDefault(CameraOptions.SizeOfHarvest(), new ImageSize(800, 600));
    private Option<ImageFormat?> Format { get; } = ImageFormatOption.Format("Image format: png, bmp or jpg (lossy) [default: png]");
    private Option<int?> Quality { get; } = ImageFormatOption.Quality();
    private Option<double> Hz { get; } =
        WithDefault(
            ValueParsers.Number(
                "--hz",
                "N",
                "Frames per second of game time",
                value => value is > 0 and <= SimulatedHarvest.TicksPerSecond,
                "a number greater than 0 and at most 60"
            ),
            10
        );
    private Option<string> DetailOf { get; } = DetailOption.Create();
    private MomentOptions Moment { get; } = new();
    private EventChoice EventsOf { get; } = new();
    private Option<bool> NoReport { get; } = ReportOption.Create();

    public static Command Create(Terminal terminal) => new ScenarioRunCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        Argument<FileInfo> file = ScenarioCommand.FileArgument();
        var command = new Command("run", "Stage a scenario in the simulated game and harvest it.")
        {
            file,
            Out,
            Overwrite,
            Resume,
            Seed,
            Seeds,
            Roads,
            Near,
            Brake,
            Change,
            Crashes,
            Size,
            Format,
            Quality,
            Hz,
            DetailOf,
            NoReport,
        };
        Moment.AddTo(command);
        EventsOf.AddTo(command);
        HelpWithNotes.AddTo(command, Notes, OptionGroups.OfScenario);
        command.SetAction(
            (parsed, cancellation) =>
                Task.FromResult(Run(terminal, ScenarioCommand.Read(parsed.GetRequiredValue(file)), parsed, cancellation))
        );
        return command;
    }

    private int Run(Terminal terminal, ScenarioTemplate template, ParseResult parsed, CancellationToken cancellation)
    {
        ResumeOption.Check(parsed.GetValue(Resume), parsed.GetValue(Overwrite));
        string folder = parsed.GetRequiredValue(Out);
        if (parsed.GetValue(Seeds) is not { } seeds)
        {
            return RunOne(terminal, template, parsed.GetValue(Seed), folder, parsed, cancellation);
        }

        int skipped = 0;
        foreach (int seed in seeds.All)
        {
            string own = Path.Combine(folder, seed.ToString(CultureInfo.InvariantCulture));
            try
            {
                int code = RunOne(terminal, template, seed, own, parsed, cancellation);
                if (code != ExitCode.Done)
                {
                    return code;
                }
            }
            catch (ScenarioUnfitException e)
            {
                skipped++;
                terminal.WriteError(FormattableString.Invariant($"Seed {seed} is skipped. {e.Message}"));
            }
        }

        terminal.Out.WriteLine($"{Counted.Of(seeds.All.Count() - skipped, "session")} in {folder}, {skipped} skipped");
        return skipped == 0 ? ExitCode.Done : ExitCode.HarvestFault;
    }

    private int RunOne(
        Terminal terminal,
        ScenarioTemplate template,
        int seed,
        string folder,
        ParseResult parsed,
        CancellationToken cancellation
    )
    {
        CounterfactualRuns? changed = ChangedIn(template, parsed);
        var planned = new PlannedScenario(template, seed) { IsEgoBlind = !IsOn(parsed, Brake) };
        ImageFormat format = parsed.GetValue(Format) ?? ImageFormat.Png;
        HarvestPlan ordinary = ScenarioHarvest.Of(
            planned,
            folder,
            new HarvestOptions
            {
                Image = parsed.GetValue(Size),
                Format = format,
                JpegQuality = ImageFormatOption.QualityOf(parsed, Quality, format),
                RateHz = parsed.GetValue(Hz),
                Events = EventsOf.Parse(parsed),
                MaxCalibrationErrorPixels = 1,
            },
            parsed.GetValue(Roads)?.FullName,
            parsed.GetValue(Near)
        );
        HarvestPlan plan = ordinary with
        {
            Variety = ordinary.Variety with { HasCrashes = IsOn(parsed, Crashes) },
            Overwrite = parsed.GetValue(Overwrite),
            Resume = parsed.GetValue(Resume),
            Weather = Moment.Weather(parsed),
            TimeOfDay = Moment.TimeOfDay(parsed),
            DayOfYear = Moment.DayOfYear(parsed),
            Detail = DetailOption.Parse(parsed.GetRequiredValue(DetailOf)),
        };
        string command = FormattableString.Invariant($"{CommandText.Of(parsed)} (seed {seed})");
        bool hasReport = !parsed.GetValue(NoReport);
        return changed is null
            ? HarvestRun.Of(terminal, plan, command, hasReport, cancellation)
            : changed.Harvest(terminal, plan, command, hasReport, cancellation);
    }

    /// <summary>The changes of the command line; null if there are none.</summary>
    private CounterfactualRuns? ChangedIn(ScenarioTemplate template, ParseResult parsed)
    {
        if (parsed.GetValue(Change) is not { Length: > 0 } texts)
        {
            return null;
        }

        if (parsed.GetValue(Seeds) is not null)
        {
            throw new UsageException("--change takes one scenario: give --seed instead of --seeds.");
        }

        if (parsed.GetValue(Overwrite) || parsed.GetValue(Resume))
        {
            throw new UsageException(
                "--overwrite and --resume do not apply to --change: the same command continues what it left unfinished."
            );
        }

        var runs = new CounterfactualRuns(texts);
        foreach (TimedChange change in runs.Changes)
        {
            if (change.Actor is { } actor && template.Middle.Actors.All(each => each.Id != actor))
            {
                throw new UsageException($"--change \"{change.Text}\": the scenario has no actor '{actor}'.");
            }

            if (change.Event is { } id && template.Middle.Events.All(each => each.Id != id))
            {
                throw new UsageException($"--change \"{change.Text}\": the scenario has no event '{id}'.");
            }
        }

        return runs;
    }

    private static bool IsOn(ParseResult parsed, Option<string> option) =>
        parsed.GetRequiredValue(option) switch
        {
            "on" => true,
            "off" => false,
            var other => throw new UsageException($"{option.Name} takes on or off, not '{other}'."),
        };

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
