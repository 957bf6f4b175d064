using System.Text.Encodings.Web;
using System.Text.Json;

namespace Harvester.Exports.Maps;

/// <summary>The JSON of a nuScenes map, which is written piece by piece.</summary>
internal sealed class ExpansionJson : IDisposable
{
    /// <summary>What is held in memory, bytes.</summary>
    private const int MaxPending = 1 << 20;

    public ExpansionJson(Stream stream)
    {
        // Names of lanes have a > sign, which needs no escape in a file.
        Writer = new Utf8JsonWriter(stream, new JsonWriterOptions { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping });
        Writer.WriteStartObject();
    }

    public Utf8JsonWriter Writer { get; }

    /// <summary>Writes a layer: a list of records.</summary>
    public void List<T>(string name, IEnumerable<T> items, Action<T> writeFields)
    {
        Writer.WriteStartArray(name);
        foreach (T item in items)
        {
            Writer.WriteStartObject();
            writeFields(item);
            Writer.WriteEndObject();
            Drain();
        }

        Writer.WriteEndArray();
    }

    /// <summary>Writes a layer whose records have names.</summary>
    public void Map<T>(string name, IEnumerable<T> items, Action<T> writeNamed)
    {
        Writer.WriteStartObject(name);
        foreach (T item in items)
        {
            writeNamed(item);
            Drain();
        }

        Writer.WriteEndObject();
    }

    /// <summary>Writes a list of tokens.</summary>
    public void Tokens(string name, IEnumerable<string> tokens)
    {
        Writer.WriteStartArray(name);
        foreach (string token in tokens)
        {
            Writer.WriteStringValue(token);
        }

        Writer.WriteEndArray();
    }

    /// <summary>Ends the file. A file that is not ended is not valid.</summary>
    public void End()
    {
        Writer.WriteEndObject();
        Writer.Flush();
    }

    public void Dispose() => Writer.Dispose();

    private void Drain()
    {
        if (Writer.BytesPending > MaxPending)
        {
            Writer.Flush();
        }
    }
}
