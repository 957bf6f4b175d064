using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Exports;

/// <summary>The classes of a dataset, and the objects that belong to them.</summary>
internal sealed class ClassCatalogue
{
    private const int SubclassesPerClass = 1000;
    private static readonly LightState[] KnownStates = [LightState.Red, LightState.Amber, LightState.Green];

    private readonly ExportOptions _options;
    private readonly List<DatasetClass> _classes = [];
    private readonly Dictionary<string, DatasetClass> _byName = [];

    /// <summary>Lists the classes of an export.</summary>
    public ClassCatalogue(ExportOptions options)
    {
        _options = options;
        foreach (ObjectClass kind in options.ClassList)
        {
            int category = (int)kind + 1;
            Add(NameOf(kind), category, kind);
            foreach ((string detail, int place) in DetailsOf(kind).Select((detail, index) => (detail, index + 1)))
            {
                Add(NameOf(kind, detail), (category * SubclassesPerClass) + place, kind);
            }
        }
    }

    /// <summary>The classes, by number.</summary>
    public IReadOnlyList<DatasetClass> All => _classes;

    /// <summary>The class of an object; null if its class is not exported.</summary>
    public DatasetClass? Of(ObjectLabel label) =>
        _options.Includes(label.Class)
            ? DetailOf(label) is { } detail && _byName.TryGetValue(NameOf(label.Class, detail), out DatasetClass? subclass)
                ? subclass
                : Of(label.Class)
            : null;

    /// <summary>The class of objects without subclass; null if it is not exported.</summary>
    public DatasetClass? Of(ObjectClass kind) => _options.Includes(kind) ? _byName[NameOf(kind)] : null;

    private void Add(string name, int category, ObjectClass kind)
    {
        if (!_byName.ContainsKey(name))
        {
            var added = new DatasetClass(_classes.Count, category, name, kind);
            _classes.Add(added);
            _byName.Add(name, added);
        }
    }

    private string NameOf(ObjectClass kind) => _options.Names.TryGetValue(kind, out string? name) ? name : JsonName.Of(kind);

    private string NameOf(ObjectClass kind, string detail) => $"{NameOf(kind)}-{detail}";

    private IEnumerable<string> DetailsOf(ObjectClass kind) =>
        kind switch
        {
            ObjectClass.Sign when _options.Subclasses.HasFlag(Subclasses.Mutcd) => _options.MutcdCodes,
            ObjectClass.TrafficLight when _options.Subclasses.HasFlag(Subclasses.Light) => KnownStates.Select(JsonName.Of),
            _ => [],
        };

    private static string? DetailOf(ObjectLabel label) =>
        label.Face is { Light: { } light } ? JsonName.Of(light.State) : label.Face?.MutcdCode;
}
