using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>A table whose records come from scenes: a list, with a record per line. A record is an action that writes its fields.</summary>
/// <param name="name">Name of its file, without the extension.</param>
/// <param name="recordsOf">The records of a scene.</param>
/// <param name="fixedRecords">Records that every dataset has.</param>
internal sealed class NuScenesRecords(
    string name,
    Func<NuScenesScene, IEnumerable<Action<Utf8JsonWriter>>> recordsOf,
    IEnumerable<Action<Utf8JsonWriter>>? fixedRecords = null
) : NuScenesTable(name)
{
    private bool _hasRecord;

    public override void Add(TextWriter writer, NuScenesScene scene) => Write(writer, recordsOf(scene));

    public override void End(TextWriter writer)
    {
        Write(writer, fixedRecords ?? []);
        writer.Write(_hasRecord ? "\n]\n" : "[]\n");
    }

    private void Write(TextWriter writer, IEnumerable<Action<Utf8JsonWriter>> records)
    {
        foreach (Action<Utf8JsonWriter> record in records)
        {
            writer.Write(_hasRecord ? ",\n" : "[\n");
            writer.Write(
                JsonLine.Of(json =>
                {
                    json.WriteStartObject();
                    record(json);
                    json.WriteEndObject();
                })
            );
            _hasRecord = true;
        }
    }
}
