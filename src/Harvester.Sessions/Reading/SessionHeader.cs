using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading;

/// <summary>
/// A session.json that can be changed and written again. Unchanged parts keep their bytes, and the layout is that of a harvest.
/// </summary>
internal sealed class SessionHeader
{
    private const string Settings = "settings";
    private const string ShardKey = "shard";

    private static readonly JsonSerializerOptions Relaxed = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    private SessionHeader(JsonObject json) => Json = json;

    /// <summary>The root object.</summary>
    public JsonObject Json { get; }

    /// <summary>The shard that the session is; null for a complete session.</summary>
    /// <exception cref="DatasetFormatException">The text is not a shard.</exception>
    public Shard? Shard
    {
        get =>
            (Json[Settings] as JsonObject)?[ShardKey] is { } text
                ? ShardText.Parse(text.ToString())
                    ?? throw new DatasetFormatException(
                        $"{SessionInfo.FileName}: settings.shard must be a shard such as 1/8, not '{text}'."
                    )
                : null;
        set
        {
            var settings = Json[Settings] as JsonObject;
            settings?.Remove(ShardKey);
            if (value is { } shard)
            {
                settings![ShardKey] = shard.ToString();
            }
        }
    }

    /// <summary>Says that the session has a manifest; its place in the file stays if it said so before.</summary>
    public void SetManifest() => Json["manifest"] = true;

    /// <summary>Reads the session.json of a session.</summary>
    /// <exception cref="DatasetFormatException">The file is invalid; the message names file and field.</exception>
    public static SessionHeader Read(SessionReader session)
    {
        session.ReadInfo();
        return Parse(InputFile.ReadAllBytes(session.PathOf(SessionInfo.FileName)));
    }

    /// <summary>Parses a text that <see cref="SessionInfo"/> can read.</summary>
    public static SessionHeader Parse(byte[] text) => new(JsonNode.Parse(text)!.AsObject());

    /// <summary>Makes a header of an object.</summary>
    public static SessionHeader Of(JsonObject json) => new(json);

    /// <summary>The text of the file.</summary>
    public override string ToString()
    {
        var text = new StringBuilder();
        Append(text, Json, 0);
        return text.Append('\n').ToString();
    }

    private static void Append(StringBuilder text, JsonNode? node, int depth)
    {
        switch (node)
        {
            case JsonObject members:
                text.Append('{');
                foreach ((KeyValuePair<string, JsonNode?> member, int index) in members.Select((member, index) => (member, index)))
                {
                    text.Append(index > 0 ? "," : "")
                        .Append('\n')
                        .Append(' ', 2 * (depth + 1))
                        .Append(JsonSerializer.Serialize(member.Key, Relaxed))
                        .Append(": ");
                    Append(text, member.Value, depth + 1);
                }

                text.Append(members.Count > 0 ? "\n" + new string(' ', 2 * depth) : "").Append('}');
                break;
            case JsonArray items:
                text.Append('[');
                foreach ((JsonNode? item, int index) in items.Select((item, index) => (item, index)))
                {
                    text.Append(index > 0 ? ", " : "");
                    Append(text, item, depth + 1);
                }

                text.Append(']');
                break;
            case JsonValue value when value.TryGetValue(out JsonElement element):
                text.Append(element.GetRawText());
                break;
            default:
                text.Append(node?.ToJsonString(Relaxed) ?? "null");
                break;
        }
    }
}
