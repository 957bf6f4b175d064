using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>splits.json: the scenes of each split, under names that no official split has.</summary>
internal sealed class NuScenesSplits() : NuScenesTable("splits")
{
    private readonly SortedDictionary<string, List<string>> _splits = new(StringComparer.Ordinal);

    /// <summary>The name of a split in splits.json.</summary>
    public static string NameOf(string split) => $"gta_{split}";

    public override void Add(TextWriter writer, NuScenesScene scene)
    {
        string name = NameOf(scene.Frames[0].Split);
        _splits.TryAdd(name, []);
        _splits[name].Add(scene.Name);
    }

    public override void End(TextWriter writer) =>
        writer.Write(
            JsonLine.Of(json =>
            {
                json.WriteStartObject();
                foreach ((string name, List<string> scenes) in _splits)
                {
                    json.WriteStartArray(name);
                    scenes.ForEach(json.WriteStringValue);
                    json.WriteEndArray();
                }

                json.WriteEndObject();
            }) + "\n"
        );
}
