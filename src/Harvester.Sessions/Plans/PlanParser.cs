using System.Globalization;
using System.Text.RegularExpressions;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Plans;

/// <summary>Reads a plan file, as docs/plans.md describes it.</summary>
public sealed class PlanParser
{
    /// <summary>Maximum number of trials.</summary>
    public const int MaxTrials = 100_000;

    private const int MaxFrames = 1_000_000;
    private const int MinSide = 32;
    private const int MaxSide = 8192;
    private const int MaxItems = 1000;
    private static readonly Regex NameForm = new(@"\A[A-Za-z0-9][A-Za-z0-9-]{0,29}\z", RegexOptions.CultureInvariant);
    private static readonly Regex FileForm = new(@"\A[^/\\:*?""<>|]+(/[^/\\:*?""<>|]+)*\z", RegexOptions.CultureInvariant);
    private static readonly string[] PlaceKinds = ["x", "space", "spread", "path"];
    private readonly CheckedJson _file;
    private readonly List<string> _problems = [];

    private PlanParser(CheckedJson file) => _file = file;

    /// <summary>Reads the text of a plan file, with all its problems.</summary>
    public static PlanReading Read(string text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        try
        {
            var parser = new PlanParser(CheckedJson.Parse(text, "a plan"));
            Plan plan = parser.Read();
            return new PlanReading(parser._problems.Count == 0 ? plan : null, parser._problems);
        }
        catch (FormatException e)
        {
            return new PlanReading(null, [e.Message]);
        }
    }

    /// <summary>Whether a text can be the name of a plan, place or camera.</summary>
    internal static bool IsName(string text) => NameForm.IsMatch(text);

    private Plan Read()
    {
        var plan = new Plan(Try(() => NameOf(_file), ""), PlacesOf())
        {
            Seed = Try(() => _file.Whole("seed", 0, int.MaxValue, 1), 1),
            Weathers = WeathersOf(),
            Hours = HoursOf(),
            Cameras = CamerasOf(),
            Repetitions = Try(() => _file.Whole("repetitions", 1, MaxItems, 1), 1),
            Frames = Try(() => _file.Whole("frames", 1, MaxFrames, 100), 1),
            Hz = Try(() => _file.Number("hz", 0.01, 60, 10), 1),
            SpeedMetresPerSecond = Try(() => _file.Number("speed", 1, 50, 12), 1),
            Traffic = Try(() => _file.Number("traffic", 0, 4, 1), 1),
            Pedestrians = Try(() => _file.Number("pedestrians", 0, 5, 1), 1),
            Parked = Try(() => _file.Number("parked", 0, 2.5, 1), 1),
            Masks = Try(MasksOf, PlanMasks.Off),
            Events = Try(() => _file.Flag("events", false), false),
        };
        Try(() => _file.Text("$schema", ""), "");
        if (plan.Masks == PlanMasks.Coded && plan.Cameras.Any(camera => camera.RigFile is not null))
        {
            _problems.Add("masks must be off or rays: with a rig, masks come from rays.");
        }

        double trials =
            plan.Places.Sum(place => place.Spread ?? 1.0) * plan.Weathers.Count * plan.Hours.Count * plan.Cameras.Count * plan.Repetitions;
        if (trials > MaxTrials)
        {
            _problems.Add(
                FormattableString.Invariant(
                    $"places, weathers, hours, cameras and repetitions give {trials} trials; at most {MaxTrials} are allowed."
                )
            );
        }

        _problems.AddRange(_file.Unknown);
        return plan;
    }

    private PlanPlace[] PlacesOf()
    {
        CheckedJson[] places = Items("places");
        PlanPlace[] read = [.. places.Select(place => Whole(place, PlaceOf)).OfType<PlanPlace>()];
        CheckNames("places", read.Select(place => place.Name));
        return read;
    }

    private static PlanPlace PlaceOf(CheckedJson place)
    {
        const double reach = 20_000;
        string name = NameOf(place);
        string[] kinds = [.. PlaceKinds.Where(place.Has)];
        string? scenario = place.Has("scenario") ? ScenarioOf(place) : null;
        if (kinds.Length != 1 && !(kinds.Length == 0 && scenario is not null))
        {
            throw place.Wrong(
                "name",
                kinds.Length == 0
                    ? $"followed by a place: '{name}' needs x and y, space, spread, path or scenario"
                    : $"followed by one kind of place: '{name}' has {string.Join(" and ", kinds)}"
            );
        }

        var made = new PlanPlace(name)
        {
            Seconds = place.Has("seconds") ? place.Number("seconds", 0.1, 86_400) : null,
            Metres = place.Has("metres") ? place.Number("metres", 1, 1_000_000) : null,
            Scenario = scenario,
        };
        switch (kinds.Length == 0 ? "scenario" : kinds[0])
        {
            case "x":
                return made with
                {
                    Point = new(place.Number("x", -reach, reach), place.Number("y", -reach, reach)),
                    HeadingDegrees = place.Has("headingDegrees") ? place.Number("headingDegrees", -360, 360) : null,
                };
            case "space":
                return made with { Space = place.Text("space"), MetresBefore = place.Number("metresBefore", 1, 300, 50) };
            case "scenario":
                return made;
            case "spread":
                return made with { Spread = place.Whole("spread", 1, 10_000) };
            default:
                Geometry.Vector2D[] path = place.Points("path", reach);
                return path.Length is >= 2 and <= 100_000 && path.Zip(path.Skip(1), (a, b) => (b - a).Length).All(length => length > 0)
                    ? made with
                    {
                        Path = path,
                    }
                    : throw place.Wrong("path", "a list of 2 to 100000 points, each unlike the one before");
        }
    }

    private static string ScenarioOf(CheckedJson place)
    {
        string file = place.Text("scenario");
        return place.Has("path") ? throw place.Wrong("scenario", "left out where path is given")
            : IsWithin(file) ? file
            : throw place.Wrong("scenario", "a path within the plan's folder, with forward slashes");
    }

    private static bool IsWithin(string file) => FileForm.IsMatch(file) && !file.Split('/').Contains("..");

    private PlanCamera[] CamerasOf()
    {
        if (!_file.Has("cameras"))
        {
            Try(() => _file.List("cameras"), []);
            return [new PlanCamera("camera", new ImageSize(800, 600), 50, null)];
        }

        CheckedJson[] cameras = Items("cameras");
        PlanCamera[] read = [.. cameras.Select(camera => Whole(camera, CameraOf)).OfType<PlanCamera>()];
        CheckNames("cameras", read.Select(camera => camera.Name));
        return read;
    }

    private static PlanCamera CameraOf(CheckedJson camera)
    {
        string name = NameOf(camera);
        if (camera.Has("rig"))
        {
            string file = camera.Text("rig");
            return IsWithin(file)
                ? new PlanCamera(name, new ImageSize(800, 600), 50, file)
                : throw camera.Wrong("rig", "a path within the plan's folder, with forward slashes");
        }

        return new PlanCamera(
            name,
            new ImageSize(camera.Whole("width", MinSide, MaxSide, 800), camera.Whole("height", MinSide, MaxSide, 600)),
            camera.Number("verticalFovDegrees", 1, 130, 50),
            null
        );
    }

    private string[] WeathersOf()
    {
        string[] weathers = Texts("weathers", "clear");
        for (int i = 0; i < weathers.Length; i++)
        {
            if (!WeatherNames.IsKnown(weathers[i]))
            {
                _problems.Add(
                    FormattableString.Invariant($"weathers[{i}] must be one of {string.Join(", ", WeatherNames.All)}, not '{weathers[i]}'.")
                );
            }
        }

        return weathers;
    }

    private TimeSpan[] HoursOf()
    {
        string[] texts = Texts("hours", "12:00");
        var hours = new List<TimeSpan>();
        for (int i = 0; i < texts.Length; i++)
        {
            if (TimeSpan.TryParseExact(texts[i], @"hh\:mm", CultureInfo.InvariantCulture, out TimeSpan hour))
            {
                hours.Add(hour);
            }
            else
            {
                _problems.Add(FormattableString.Invariant($"hours[{i}] must be a time of day such as 18:30, not '{texts[i]}'."));
            }
        }

        return [.. hours];
    }

    private PlanMasks MasksOf() =>
        _file.Text("masks", "off") switch
        {
            "off" => PlanMasks.Off,
            "rays" => PlanMasks.Rays,
            "coded" => PlanMasks.Coded,
            var other => throw _file.Wrong("masks", $"off, rays or coded, not '{other}'"),
        };

    /// <summary>Reads an object; null if it has a problem. Its unknown fields are known only if nothing else is wrong.</summary>
    private T? Whole<T>(CheckedJson fields, Func<CheckedJson, T> read)
        where T : class
    {
        T? made = Try(() => read(fields), null!);
        if (made is not null)
        {
            _problems.AddRange(fields.Unknown);
        }

        return made;
    }

    private CheckedJson[] Items(string name)
    {
        CheckedJson[] items = Try(() => _file.List(name), []);
        if (items.Length is 0 or > MaxItems && _problems.All(problem => !problem.StartsWith(name, StringComparison.Ordinal)))
        {
            _problems.Add(FormattableString.Invariant($"{name} must be a list of 1 to {MaxItems} objects."));
        }

        return items;
    }

    private string[] Texts(string name, string otherwise)
    {
        string[] texts = Try(() => _file.Has(name) ? _file.Texts(name) : [_file.Text(name, otherwise)], []);
        if (texts.Length > 0 && texts.Distinct().Count() < texts.Length)
        {
            _problems.Add($"{name} must be values that all differ.");
        }
        else if (texts.Length == 0 && _problems.All(problem => !problem.StartsWith(name, StringComparison.Ordinal)))
        {
            _problems.Add($"{name} must have at least one value.");
        }

        return texts;
    }

    private void CheckNames(string list, IEnumerable<string> names) =>
        _problems.AddRange(
            names
                .GroupBy(name => name, StringComparer.OrdinalIgnoreCase)
                .Where(group => group.Count() > 1)
                .Select(group => $"{list} must have names that all differ, in capitals or not; '{group.Key}' occurs twice.")
        );

    private static string NameOf(CheckedJson named)
    {
        string name = named.Text("name");
        return IsName(name)
            ? name
            : throw named.Wrong("name", $"1 to 30 letters, digits and -, beginning with a letter or digit, not '{name}'");
    }

    private T Try<T>(Func<T> read, T otherwise)
    {
        try
        {
            return read();
        }
        catch (FormatException e)
        {
            _problems.Add(e.Message);
            return otherwise;
        }
    }
}
