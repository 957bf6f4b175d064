using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Json.Schema;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Compares a session with the published JSON Schemas in docs/schema, which have every field and no other. This takes many times as long as
/// <see cref="SessionValidator"/>, which checks more than a schema can express.
/// </summary>
public static class SchemaValidator
{
    private const string UnknownField = "the field is unknown.";
    private const int MaxNumberCharacters = 40;
    private static readonly EvaluationOptions Detailed = new() { OutputFormat = OutputFormat.Hierarchical };

    /// <summary>The differences from the schemas, one for each line at most; empty if there are none.</summary>
    /// <param name="session">The session.</param>
    /// <param name="cancellation">Stops between two lines.</param>
    public static IReadOnlyList<SessionProblem> Problems(SessionReader session, CancellationToken cancellation = default)
    {
        System.ArgumentNullException.ThrowIfNull(session);
        var problems = new ProblemList();
        byte[] header = InputFile.ReadAllBytes(session.PathOf(SessionInfo.FileName));
        if (Problem(Schema("session"), Encoding.UTF8.GetString(header)) is { } wrong)
        {
            problems.Add(new SessionProblem(SessionInfo.FileName, null, wrong));
        }

        JsonSchema label = Schema("label");
        foreach ((int index, string text) in session.ReadTexts().Index())
        {
            cancellation.ThrowIfCancellationRequested();
            if (Problem(label, text) is { } problem)
            {
                problems.Add(new SessionProblem(SessionReader.LabelsFile, index + 1, problem));
            }

            if (problems.IsFull)
            {
                break;
            }
        }

        JsonSchema happened = Schema("event");
        foreach (EventLine line in session.ReadEventLines())
        {
            cancellation.ThrowIfCancellationRequested();
            if (Problem(happened, line.Text) is { } problem)
            {
                problems.Add(new SessionProblem(FramePaths.Events, line.Number, problem));
            }

            if (problems.IsFull)
            {
                break;
            }
        }

        return problems;
    }

    /// <summary>The text of a schema: label, session or event.</summary>
    internal static string SchemaText(string name)
    {
        using Stream stream = typeof(SchemaValidator).Assembly.GetManifestResourceStream($"Harvester.Datasets.{name}.schema.json")!;
        using var reader = new StreamReader(stream);
        return reader.ReadToEnd();
    }

    private static JsonSchema Schema(string name) => JsonSchema.FromText(SchemaText(name));

    private static string? Problem(JsonSchema schema, string json)
    {
        EvaluationResults results;
        try
        {
            using JsonDocument document = JsonInput.Parse(json);
            if (LargeNumber(document.RootElement) is { } number)
            {
                return $"schema: {(number.Length > MaxNumberCharacters ? number[..MaxNumberCharacters] + "..." : number)} is too large.";
            }

            results = schema.Evaluate(JsonNode.Parse(json), Detailed);
        }
        catch (JsonException e)
        {
            return JsonFault.InText(e);
        }
        catch (DatasetFormatException e)
        {
            return e.Message;
        }

        if (results.IsValid)
        {
            return null;
        }

        // The innermost value is what is wrong; those around it are only invalid because of it.
        (string place, string message) = Errors(results).MaxBy(static error => error.Place.Count(static sign => sign == '/'));
        return $"schema: {(place.Length == 0 ? "" : place[1..] + ": ")}{message}";
    }

    /// <summary>The first number that a decimal cannot hold, which is how the schemas' limits are compared; null for none.</summary>
    private static string? LargeNumber(JsonElement element) =>
        element.ValueKind switch
        {
            JsonValueKind.Number => element.TryGetDecimal(out _) ? null : element.GetRawText(),
            JsonValueKind.Array => element.EnumerateArray().Select(LargeNumber).FirstOrDefault(number => number is not null),
            JsonValueKind.Object => element
                .EnumerateObject()
                .Select(field => LargeNumber(field.Value))
                .FirstOrDefault(number => number is not null),
            _ => null,
        };

    /// <summary>The errors of a result. A valid one may have invalid parts: the alternatives that were not taken.</summary>
    private static IEnumerable<(string Place, string Message)> Errors(EvaluationResults results)
    {
        if (results.IsValid)
        {
            yield break;
        }

        foreach ((string keyword, string message) in results.Errors ?? new Dictionary<string, string>())
        {
            yield return (results.InstanceLocation.ToString(), keyword.Length == 0 ? UnknownField : $"{message}.");
        }

        foreach ((string, string) error in results.Details.SelectMany(Errors))
        {
            yield return error;
        }
    }
}
