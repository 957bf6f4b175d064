using Harvester.Exports.Maps;
using Harvester.Geometry;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The files of the map expansion, one for each scene whose roads are known.</summary>
internal static class NuScenesExpansions
{
    private const string PartPrefix = "lanes ";
    private const char Separator = ';';

    /// <summary>The location of a scene: the first scenes have the names that the devkit's map reader accepts.</summary>
    /// <param name="scene">Its number.</param>
    /// <param name="hasLanes">Whether its roads are known.</param>
    /// <param name="log">The name of its log.</param>
    public static string LocationOf(int scene, bool hasLanes, string log) =>
        hasLanes && scene < NuScenesExpansion.Names.Count ? NuScenesExpansion.Names[scene] : log;

    /// <summary>Path of the map of a location.</summary>
    public static string PathOf(string location) => $"maps/expansion/{location}.json";

    /// <summary>What is wrong with a location: one that has the name of a map without having the map. Null if nothing is.</summary>
    public static string? ProblemOf(DatasetContent dataset, string location) =>
        NuScenesExpansion.Names.Contains(location) && !dataset.Has(PathOf(location)) ? $"its map '{PathOf(location)}' is missing." : null;

    /// <summary>Adds the lanes near a frame, and what belongs to them.</summary>
    /// <param name="output">Takes the part.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="area">The part of the world around it.</param>
    /// <param name="things">Lanes, stop lines, signals and crossings as texts.</param>
    public static void Add(FrameOutput output, ExportFrame frame, NuScenesArea area, IEnumerable<string> things) =>
        output.Part(
            FormattableString.Invariant($"{PartPrefix}{frame.RecordingIndex:D8} {frame.Label.Place ?? 0:D8}"),
            string.Join(Separator, things.Prepend(area.ToString()))
        );

    /// <summary>The maps of all scenes.</summary>
    /// <param name="places">The sessions at places that are scenes, in the order of their numbers.</param>
    /// <param name="hasPart">Whether a part of this name exists.</param>
    public static IEnumerable<AggregateFile> Files(IEnumerable<string> places, Predicate<string> hasPart) =>
        places
            .Select((place, scene) => (Part: PartPrefix + place, Scene: scene, Place: place))
            .Where(item => hasPart(item.Part))
            .Select(item => new AggregateFile(
                PathOf(LocationOf(item.Scene, hasLanes: true, LogOf(item.Place))),
                [AggregateSection.Binary(item.Part, Write)]
            ));

    private static string LogOf(string place)
    {
        int[] numbers = [.. Numbers.Parse(place.Split(' '))!.Select(number => (int)number)];
        return NuScenesWriter.LogOf(numbers[0], numbers[1]);
    }

    private static void Write(Stream stream, IEnumerable<string> lines)
    {
        var areas = new List<NuScenesArea>();
        var known = new HashSet<string>(StringComparer.Ordinal);
        var things = new List<string>();
        foreach (string[] items in lines.Select(line => line.Split(Separator)))
        {
            areas.Add(NuScenesArea.Parse(items[0]));
            things.AddRange(items.Skip(1).Where(known.Add));
        }

        NuScenesArea area = NuScenesArea.Of(areas);
        ILookup<string, string> kinds = things.ToLookup(KindOf, StringComparer.Ordinal);
        ExpansionLane[] lanes =
        [
            .. kinds[""].Select(ExpansionLane.Parse).Where(lane => lane.Left.Concat(lane.Right).All(point => IsOn(area, point))),
        ];
        HashSet<string> names = lanes.Select(lane => lane.Id).ToHashSet(StringComparer.Ordinal);
        HashSet<string> roads = lanes.Select(lane => lane.Road).ToHashSet(StringComparer.Ordinal);

        // The lanes of a light or sign are those of one road.
        var content = new ExpansionContent(lanes)
        {
            StopLines = [.. kinds[ExpansionStopLine.Prefix].Select(ExpansionStopLine.Parse).Where(line => line.Lanes.All(names.Contains))],
            Signals = [.. kinds[ExpansionSignal.Prefix].Select(ExpansionSignal.Parse).Where(signal => signal.Lanes.All(names.Contains))],
            Crossings =
            [
                .. kinds[ExpansionCrossing.Prefix].Select(ExpansionCrossing.Parse).Where(crossing => roads.Contains(crossing.Road)),
            ],
        };
        var offset = new Vector2D(area.Offset.X, area.Offset.Y);
        new ExpansionLayers(content, offset, new Vector2D(area.Width, area.Height)).Write(stream);
    }

    private static string KindOf(string thing) =>
        thing.StartsWith('#') ? thing[..thing.IndexOf(ExpansionText.Field, StringComparison.Ordinal)] : "";

    private static bool IsOn(NuScenesArea area, Vector2D point) =>
        point.X >= area.West && point.X <= area.East && point.Y >= area.South && point.Y <= area.North;
}
