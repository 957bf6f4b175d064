using System.Text.RegularExpressions;
using Harvester.Geometry.Maps;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Scenarios;

/// <summary>Reads a scenario file, as docs/scenarios.md describes it.</summary>
public sealed class ScenarioParser
{
    private const int MaxItems = 100;
    private const double Fastest = 60;
    private const double Farthest = 500;
    private static readonly Regex NameForm = new(@"\A[A-Za-z0-9][A-Za-z0-9-]{0,29}\z", RegexOptions.CultureInvariant);
    private readonly CheckedJson _file;
    private readonly List<string> _problems = [];

    private ScenarioParser(CheckedJson file) => _file = file;

    /// <summary>Reads the text of a scenario file, with all its problems.</summary>
    /// <param name="text">The text.</param>
    public static ScenarioReading Read(string text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        try
        {
            ScenarioParameter[] parameters = ScenarioParameters.Of(text);
            var problems = new List<string>();
            Scenario? middle = null;

            // Values in the middle first, then those at the ends of their ranges, which may be out of the range of a field.
            foreach (IReadOnlyDictionary<string, double> values in ScenarioParameters.Probes(parameters))
            {
                var parser = new ScenarioParser(CheckedJson.Parse(text, "a scenario", new NumberTerms(values)));
                Scenario read = parser.Read();
                middle ??= read with { Values = values };
                problems.AddRange(parser._problems.Where(problem => !problems.Contains(problem)));
            }

            return new ScenarioReading(problems.Count == 0 ? new ScenarioTemplate(text, middle!, parameters) : null, problems);
        }
        catch (FormatException e)
        {
            return new ScenarioReading(null, [e.Message]);
        }
    }

    /// <summary>Reads a file without problems with given values of its parameters.</summary>
    internal static Scenario Read(string text, IReadOnlyDictionary<string, double> values) =>
        new ScenarioParser(CheckedJson.Parse(text, "a scenario", new NumberTerms(values))).Read() with
        {
            Values = values,
        };

    /// <summary>Whether a text can be the name of a scenario, an actor or an event.</summary>
    internal static bool IsName(string text) => NameForm.IsMatch(text);

    private Scenario Read()
    {
        ScenarioActor[] actors = Items("actors", ActorOf);
        var scenario = new Scenario(
            Try(() => NameOf(_file, "name"), ""),
            Try(() => NameOf(_file, "kind"), ""),
            actors,
            Items("events", item => ScenarioEventParser.Read(item, [.. actors.Select(actor => actor.Id)]))
        )
        {
            Description = Try(() => _file.Text("description", ""), ""),
            Ego = Try(() => _file.Fields("ego") is { } ego ? EgoOf(ego) : new(), new()),
            Place = Try(() => _file.Fields("place") is { } place ? NeedsOf(place) : new(), new()),
            End = Try(() => _file.Fields("end") is { } end ? EndOf(end) : new(), new()),
        };
        Try(() => _file.Text("$schema", ""), "");
        _ = Try(() => _file.Fields("parameters"), null);
        if (actors.Length == 0 && _problems.All(problem => !problem.StartsWith("actors", StringComparison.Ordinal)))
        {
            _problems.Add(FormattableString.Invariant($"actors must be a list of 1 to {MaxItems} objects."));
        }

        CheckNames("actors", actors.Select(actor => actor.Id));
        CheckNames("events", scenario.Events.Select(each => each.Id));
        CheckReferences(scenario);
        _problems.AddRange(_file.Unknown);
        return scenario;
    }

    private static ScenarioActor ActorOf(CheckedJson item)
    {
        string id = NameOf(item, "id");
        ScenarioActorType type = item.Choice<ScenarioActorType>("type");
        return new ScenarioActor(
            id,
            type,
            item.Text("model", DefaultModel(type)),
            StartParser.Read(item.Fields("start") ?? throw item.Wrong("start", "an object")),
            item.Has("speed") ? item.Number("speed", 0, Fastest)
                : type is ScenarioActorType.Vehicle or ScenarioActorType.Cyclist ? null
                : 0
        )
        {
            IgnoresOthers = item.Flag("ignoresOthers", true),
        };
    }

    private static string DefaultModel(ScenarioActorType type) =>
        type switch
        {
            ScenarioActorType.Vehicle => "car",
            ScenarioActorType.Cyclist => "bicycle",
            ScenarioActorType.Pedestrian => "pedestrian",
            ScenarioActorType.Animal => "dog",
            _ => "cone",
        };

    private static ScenarioEgo EgoOf(CheckedJson ego) =>
        Ended(ego, new ScenarioEgo { Speed = ego.Number("speed", 1, Fastest, 10), Turn = ego.Choice("turn", MapTurn.Straight) });

    private static ScenarioNeeds NeedsOf(CheckedJson place) =>
        Ended(
            place,
            new ScenarioNeeds
            {
                Lanes = place.Whole("lanes", 1, 10, 1),
                LanesLeft = place.Whole("lanesLeft", 0, 9, 0),
                LanesRight = place.Whole("lanesRight", 0, 9, 0),
                OncomingLane = place.Flag("oncomingLane", false),
                Street = place.Flag("street", false),
                StraightMetres = place.Number("straightMetres", 0, Farthest, 0),
                Metres = place.Number("metres", 0, Farthest, 60),
                Crossing = place.Has("crossing") ? RangeOf(place, "crossing") : null,
                Junction = place.Fields("junction") is { } junction ? JunctionOf(junction) : null,
            }
        );

    private static ScenarioJunction JunctionOf(CheckedJson junction)
    {
        (double from, double to) = RangeOf(junction, "within");
        return Ended(
            junction,
            new ScenarioJunction(from, to)
            {
                Light = junction.Has("light") ? junction.Flag("light", false) : null,
                Approaches = junction.Has("approaches") ? junction.Choices<ScenarioApproach>("approaches") : [],
            }
        );
    }

    private static (double From, double To) RangeOf(CheckedJson fields, string name)
    {
        double[] ends = fields.Numbers(name, 0, Farthest);
        return ends.Length == 2 && ends[0] <= ends[1] ? (ends[0], ends[1]) : throw fields.Wrong(name, "two numbers, the smaller one first");
    }

    private static ScenarioEnd EndOf(CheckedJson end) =>
        Ended(
            end,
            new ScenarioEnd
            {
                Seconds = end.Number("seconds", 1, 600, 15),
                Metres = end.Has("metres") ? end.Number("metres", 1, 10_000) : null,
                EgoPassedAll = end.Flag("egoPassedAll", false),
                Collision = end.Flag("collision", false),
            }
        );

    private void CheckReferences(Scenario scenario)
    {
        foreach (ScenarioEvent each in scenario.Events)
        {
            foreach (string named in each.When.Select(condition => condition.Event).OfType<string>())
            {
                if (scenario.Events.All(other => other.Id != named || other == each))
                {
                    _problems.Add($"event '{each.Id}': '{named}' is not another event.");
                }
            }
        }
    }

    internal static T Ended<T>(CheckedJson fields, T read)
    {
        fields.End();
        return read;
    }

    internal static string NameOf(CheckedJson named, string field)
    {
        string name = named.Text(field);
        return IsName(name)
            ? name
            : throw named.Wrong(field, $"1 to 30 letters, digits and -, beginning with a letter or digit, not '{name}'");
    }

    private T[] Items<T>(string name, Func<CheckedJson, T> read)
        where T : class
    {
        CheckedJson[] items = Try(() => _file.List(name), []);
        if (items.Length > MaxItems)
        {
            _problems.Add(FormattableString.Invariant($"{name} must be a list of at most {MaxItems} objects."));
            return [];
        }

        return [.. items.Select(item => Try(() => Ended(item, read(item)), null!)).Where(made => made is not null)];
    }

    private void CheckNames(string list, IEnumerable<string> names) =>
        _problems.AddRange(
            names
                .GroupBy(name => name, StringComparer.Ordinal)
                .Where(group => group.Count() > 1)
                .Select(group => $"{list} must have ids that all differ; '{group.Key}' occurs twice.")
        );

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
