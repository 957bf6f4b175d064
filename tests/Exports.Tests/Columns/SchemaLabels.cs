using System.Text.Json.Nodes;

namespace Harvester.Exports.Tests.Columns;

/// <summary>
/// Label lines that have every field of docs/schema/label.schema.json, filled with numbers that occur once, so that a value in a wrong
/// column is noticed. A field that may be null or absent sometimes is.
/// </summary>
/// <param name="seed">Seed of what is null or absent.</param>
internal sealed class SchemaLabels(int seed)
{
    private const int Items = 3;

    private static readonly JsonObject Schema = JsonNode
        .Parse(File.ReadAllText(Path.Combine(DocumentedTable.Root, "docs/schema/label.schema.json")))!
        .AsObject();

    private readonly Random _random = new(seed);
    private int _next;

    /// <summary>Every leaf of the schema as a path such as "objects[].box3d.centre[]".</summary>
    public static IReadOnlyCollection<string> Leaves { get; } = [.. LeavesOf(Schema, "").Distinct()];

    /// <summary>A label line.</summary>
    /// <param name="isWhole">Whether it has every field.</param>
    public JsonObject Line(bool isWhole) => Value(Schema, isWhole)!.AsObject();

    private JsonNode? Value(JsonNode schema, bool isWhole)
    {
        JsonObject node = Resolved(schema);
        if (Choices(node) is { } choices)
        {
            JsonNode[] real = [.. choices.Where(choice => (string?)Resolved(choice)["type"] != "null")];
            return !isWhole && real.Length < choices.Length && _random.Next(2) == 0
                ? null
                : Value(real[_random.Next(real.Length)], isWhole);
        }

        if (node["const"] is { } constant)
        {
            return constant.DeepClone();
        }

        if (node["enum"] is JsonArray values)
        {
            JsonNode?[] real = [.. values.Where(value => value is not null || !isWhole)];
            return real[_random.Next(real.Length)]?.DeepClone();
        }

        string[] types = node["type"] is JsonArray listed ? [.. listed.Select(type => (string)type!)] : [(string)node["type"]!];
        if (!isWhole && types.Contains("null") && _random.Next(2) == 0)
        {
            return null;
        }

        switch (types.First(type => type != "null"))
        {
            case "object":
                var fields = new JsonObject();
                HashSet<string> required = [.. (node["required"] as JsonArray ?? []).Select(name => (string)name!)];
                foreach ((string name, JsonNode? field) in node["properties"]!.AsObject())
                {
                    if (isWhole || required.Contains(name) || _random.Next(2) == 0)
                    {
                        fields[name] = Value(field!, isWhole);
                    }
                }

                return fields;
            case "array":
                JsonNode?[] lengths = node["anyOf"] is JsonArray several ? [.. several] : [node];
                int least = (int?)lengths[isWhole ? ^1 : _random.Next(lengths.Length)]!["minItems"] ?? Items;
                return new JsonArray([.. Enumerable.Range(0, Math.Max(least, 1)).Select(_ => Value(node["items"]!, isWhole))]);
            case "integer":
                return JsonValue.Create(++_next);
            case "number":
                return JsonValue.Create(++_next + (_random.Next(1, 1_000_000_000) / 1e9));
            case "boolean":
                return JsonValue.Create(_random.Next(2) == 0);
            default:
                return JsonValue.Create($"text {++_next} \u00e4\u4e16");
        }
    }

    private static IEnumerable<string> LeavesOf(JsonNode schema, string path)
    {
        JsonObject node = Resolved(schema);
        if (Choices(node) is { } choices)
        {
            return choices.SelectMany(choice => LeavesOf(choice, path));
        }

        if (node["properties"] is JsonObject fields)
        {
            return fields.SelectMany(field => LeavesOf(field.Value!, path.Length == 0 ? field.Key : $"{path}.{field.Key}"));
        }

        return node["items"] is { } items ? LeavesOf(items, path + "[]")
            : (string?)(node["type"] as JsonValue)?.ToString() == "null" ? []
            : [path];
    }

    /// <summary>The forms that a value may have; null if it has one, of which lists may have several lengths.</summary>
    private static JsonNode[]? Choices(JsonObject node) =>
        node["items"] is null ? (node["oneOf"] as JsonArray ?? node["anyOf"] as JsonArray)?.OfType<JsonNode>().ToArray() : null;

    private static JsonObject Resolved(JsonNode schema) =>
        (string?)schema["$ref"] is { } name ? Schema["$defs"]![name.Split('/')[^1]]!.AsObject() : schema.AsObject();
}
