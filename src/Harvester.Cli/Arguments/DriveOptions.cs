using System.CommandLine;
using System.Globalization;
using Harvester.Datasets.Roads;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Runs.Driving;
using Harvester.Runs.Evaluation.Noise;
using Harvester.Runs.Faults;
using Harvester.Sessions.Reading;
using Harvester.Simulation.World;

namespace Harvester.Cli.Arguments;

/// <summary>The options of a drive: what drives, where, how far, and in which world.</summary>
internal sealed class DriveOptions
{
    private ControllerOptions Controller { get; } = new("Controller that drives", "stanley");

    private Option<int> Seed { get; } = WithDefault(ValueParsers.Integer("--seed", "N", "Random seed", 0, int.MaxValue), 1);

    private Option<SeedRange?> Seeds { get; } =
        ValueParsers.Optional<SeedRange>(
            "--seeds",
            "A-B",
            "Drive with each of these seeds instead of one, from each start: a town and traffic for each",
            SeedRange.Parse,
            "two seeds, the smaller one first, at most 1000 in all, e.g. 701-720"
        );

    private Option<FileInfo?> Roads { get; } =
        new("--roads")
        {
            Description = "Road network to drive on, a file or folder [default: a town generated from the seed]",
            HelpName = "FILE",
        };

    private Option<FileInfo?> Paint { get; } = LaneOptions.Paint();

    private Option<string[]> Near { get; } =
        new("--near")
        {
            Description = "Start position, metres; repeatable, for several drives in a row [default: the middle of the road network]",
            HelpName = "X,Y",
            DefaultValueFactory = _ => [],
        };

    private Option<int?> Places { get; } =
        ValueParsers.Optional<int>(
            "--places",
            "N",
            "Start at N places drawn from the seed, uniformly along the roads of --roads, instead of --near",
            text => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int n) && n is > 0 and <= 1000 ? n : null,
            "a whole number from 1 to 1000"
        );

    private Option<int> Jobs { get; } =
        WithDefault(ValueParsers.Integer("--jobs", "N", "Number of drives at the same time; changes nothing in the result", 1, 256), 1);

    private Option<double> Distance { get; } = WithDefault(Positive("--distance", "M", "Distance to drive from each start, metres"), 1000);
    private Option<double> Duration { get; } =
        WithDefault(Positive("--duration", "S", "Time limit for each start, seconds of game time"), 3600);

    private Option<double> Traffic { get; } =
        WithDefault(
            ValueParsers.Number(
                "--traffic",
                "F",
                "Factor on the number of vehicles",
                value => value is >= 0 and <= 4,
                "a number from 0 to 4"
            ),
            1
        );

    private Option<double?> Speed { get; } =
        ValueParsers.Optional<double>(
            "--speed",
            "M/S",
            "Speed on a free straight road, metres per second [default: stanley 14, deepdriving 20]",
            text => NumberText.Read(text) is { } value && value is > 0 and <= 40 ? value : null,
            "a number greater than 0 and at most 40"
        );

    private Option<bool> Noise { get; } =
        new("--noise")
        {
            Description =
                "Add noise to the indicators: the errors published for DeepDriving's network (0.03 rad, 0.2 m, and 3 m on distances "
                + "to vehicles)",
        };

    private Option<double> LookAhead { get; } =
        WithDefault(
            ValueParsers.Number(
                "--look-ahead",
                "M",
                "Look-ahead distance for the angle, metres",
                value => value is > 0 and <= 40,
                "a number greater than 0 and at most 40"
            ),
            new ControllerPlan { Kind = ControllerKind.Stanley }.LookAheadMetres
        );

    private MomentOptions Moment { get; } = new();

    private Option<bool> Perturb { get; } =
        new("--perturb")
        {
            Description = "Push the steering aside now and then, seeded; recorded is what the controller answers, without the push",
        };

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        Option[] own = [Seed, Seeds, Roads, Paint, Near, Places, Jobs, Distance, Duration, Traffic, Speed, Noise, LookAhead, Perturb];
        foreach (Option option in own)
        {
            command.Options.Add(option);
        }

        Moment.AddTo(command);
        foreach (Option option in Controller.All)
        {
            command.Options.Add(option);
        }
    }

    /// <summary>The plan that the options describe, without a bridge.</summary>
    /// <exception cref="UsageException">Options exclude each other, or a position cannot be read.</exception>
    public DriveSettings Parse(ParseResult parsed)
    {
        CheckStarts(parsed);
        RoadNetwork? roads = parsed.GetValue(Roads) is { } file ? RoadImporter.Import(file.FullName).Network : null;
        int seed = parsed.GetValue(Seed);
        var settings = new DriveSettings
        {
            Controller = Controller.Parse(parsed) with { Speed = parsed.GetValue(Speed), LookAheadMetres = parsed.GetValue(LookAhead) },
            Seed = seed,
            Seeds = parsed.GetValue(Seeds) is { } seeds ? [.. seeds.All] : [],
            Roads = roads,
            Starts = parsed.GetValue(Places) is { } places
                ? RandomPlaces.On(roads!, places, seed)
                : [.. parsed.GetRequiredValue(Near).Select(ParsePlace)],
            Jobs = parsed.GetValue(Jobs),
            TrafficDensity = parsed.GetValue(Traffic),
            Metres = parsed.GetValue(Distance),
            Seconds = parsed.GetValue(Duration),
            Noise = parsed.GetValue(Noise) ? NoiseLevels.Published : null,
            IsDisturbed = parsed.GetValue(Perturb),
            Weather = Moment.Weather(parsed),
            TimeOfDay = Moment.TimeOfDay(parsed),
            DayOfYear = Moment.DayOfYear(parsed),
        };
        return settings with { Paint = PaintOf(parsed.GetValue(Paint), settings) };
    }

    /// <summary>Reads the table of paint, before anything is written.</summary>
    private static PaintTable? PaintOf(FileInfo? file, DriveSettings settings)
    {
        if (file is null)
        {
            return null;
        }

        int[] towns = settings.Roads is null ? [.. settings.Episodes.Select(episode => episode.Seed).Distinct()] : [];
        return towns.Length > 1
            ? throw new UsageException("--paint belongs to one road network. Name it with --roads, or drive in one town.")
            : PaintFile.Read(file.FullName, settings.Roads ?? TownBuilder.Build(towns[0]));
    }

    /// <summary>The settings of a drive, by name, for drive.json.</summary>
    public Dictionary<string, string> Settings(ParseResult parsed, DriveSettings plan)
    {
        Dictionary<string, string> settings = new(StringComparer.Ordinal)
        {
            ["controller"] = plan.Controller.Kind == ControllerKind.Stanley ? "stanley" : "deepdriving",
            ["emergencyBrake"] = plan.Controller.BrakesInEmergency ? "on" : "off",
            ["seed"] = plan.Seed.ToString(CultureInfo.InvariantCulture),
            ["bridge"] = plan.Bridge is { } bridge ? (bridge.Kind == BridgeName.Folder ? "folder" : "socket") : "direct",
            ["roads"] = parsed.GetValue(Roads)?.Name ?? "town",
            ["distanceMetres"] = plan.Metres.ToString(CultureInfo.InvariantCulture),
            ["durationSeconds"] = plan.Seconds.ToString(CultureInfo.InvariantCulture),
            ["traffic"] = plan.TrafficDensity.ToString(CultureInfo.InvariantCulture),
            ["lookAheadMetres"] = plan.Controller.LookAheadMetres.ToString(CultureInfo.InvariantCulture),
            ["noise"] = plan.Noise is { } noise
                ? FormattableString.Invariant($"{noise.AngleRadians} rad, {noise.MarkingMetres} m, {noise.VehicleMetres} m")
                : "none",
            ["perturb"] = plan.IsDisturbed ? "on" : "off",
            ["weather"] = plan.Weather,
            ["dayOfYear"] = plan.DayOfYear.ToString(CultureInfo.InvariantCulture),
            ["timeOfDay"] = plan.TimeOfDay.ToString(@"hh\:mm", CultureInfo.InvariantCulture),
        };
        if (parsed.GetValue(Paint) is { } paint)
        {
            settings["paint"] = paint.Name;
        }

        if (plan.Controller.Speed is { } speed)
        {
            settings["speed"] = speed.ToString(CultureInfo.InvariantCulture);
        }

        if (parsed.GetValue(Seeds) is { } seeds)
        {
            settings["seed"] = seeds.ToString();
        }

        if (plan.Starts.Count > 0)
        {
            settings["near"] = string.Join(' ', plan.Starts.Select(start => FormattableString.Invariant($"{start.X},{start.Y}")));
        }

        return settings;
    }

    /// <summary>The settings of a drive for the session that records it, which has its seed elsewhere.</summary>
    public IEnumerable<KeyValuePair<string, string>> RecordedSettings(ParseResult parsed, DriveSettings plan) =>
        Settings(parsed, plan).Where(setting => setting.Key != "seed");

    private void CheckStarts(ParseResult parsed)
    {
        if (IsGiven(Seeds) && IsGiven(Seed))
        {
            throw new UsageException("--seeds and --seed exclude each other.");
        }

        if (IsGiven(Places) && (!IsGiven(Roads) || IsGiven(Near) || IsGiven(Seeds)))
        {
            throw new UsageException("--places takes --roads, and excludes --near and --seeds.");
        }

        bool IsGiven(Option option) => parsed.GetResult(option) is { Implicit: false };
    }

    private static Vector2D ParsePlace(string text) =>
        NumberText.ReadList(text, 2) is { } n
            ? new Vector2D(n[0], n[1])
            : throw new UsageException($"--near takes two numbers, e.g. 0,-1000, not '{text}'.");

    private static Option<double> Positive(string name, string form, string description) =>
        ValueParsers.Number(name, form, description, value => value is > 0 and <= 1_000_000, "a number greater than 0 and at most 1000000");

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
