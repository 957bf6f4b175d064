using Harvester.Geometry;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The map masks, one for each scene.</summary>
internal static class NuScenesMap
{
    private const string PartPrefix = "map ";
    private const char Separator = ';';

    /// <summary>Polygons are kept to a centimetre, a tenth of a pixel.</summary>
    private const int Decimals = 2;

    /// <summary>Path of the mask of a scene.</summary>
    public static string PathOf(string scene) => $"maps/{scene}.png";

    /// <summary>Adds the ground that a frame knows of.</summary>
    /// <param name="output">Takes the part.</param>
    /// <param name="frame">The frame.</param>
    /// <param name="area">The part of the world around it.</param>
    /// <param name="ground">Polygons, metres, world.</param>
    public static void Add(FrameOutput output, ExportFrame frame, NuScenesArea area, IEnumerable<Vector2D[]> ground) =>
        output.Part(
            FormattableString.Invariant($"{PartPrefix}{frame.RecordingIndex:D8} {frame.Label.Place ?? 0:D8}"),
            string.Join(Separator, ground.Select(TextOf).Prepend(area.ToString()))
        );

    /// <summary>The masks of all scenes.</summary>
    /// <param name="places">The sessions at places that are scenes, in the order of their numbers.</param>
    public static IEnumerable<AggregateFile> Files(IEnumerable<string> places) =>
        places.Select(
            (place, scene) =>
                new AggregateFile(PathOf(NuScenesScene.NameOf(scene)), [AggregateSection.Binary(PartPrefix + place, WriteMask)])
        );

    private static void WriteMask(Stream stream, IEnumerable<string> lines)
    {
        var areas = new List<NuScenesArea>();
        var ground = new HashSet<string>(StringComparer.Ordinal);
        foreach (string[] items in lines.Select(line => line.Split(Separator)))
        {
            areas.Add(NuScenesArea.Parse(items[0]));
            ground.UnionWith(items.Skip(1));
        }

        new NuScenesMask(NuScenesArea.Of(areas), ground.Select(PolygonOf)).Write(stream);
    }

    private static string TextOf(Vector2D[] polygon) =>
        Numbers.Row(Decimals, [.. polygon.SelectMany(corner => (double[])[corner.X, corner.Y])]);

    private static Vector2D[] PolygonOf(string text) =>
        [.. Numbers.Parse(text.Split(' '))!.Chunk(2).Select(corner => new Vector2D(corner[0], corner[1]))];
}
