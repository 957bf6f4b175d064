using System.Text.Json;
using System.Text.RegularExpressions;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Recipes;

/// <summary>
/// The commands that make a dataset, instead of the dataset. A recipe with the digests of its inputs and results is locked: whoever follows
/// it knows whether the bytes are the same. docs/rebuild.md describes the file.
/// </summary>
/// <param name="Tool">The program and its version by which the digests were made; null in a recipe that is not locked.</param>
/// <param name="Inputs">The files that are not part of the recipe.</param>
/// <param name="Steps">The commands, in their order.</param>
public sealed partial record DatasetRecipe(string? Tool, IReadOnlyList<RecipeInput> Inputs, IReadOnlyList<RecipeStep> Steps)
{
    /// <summary>Name of the file that is written beside a dataset.</summary>
    public const string FileName = "dataset.lock";

    /// <summary>Maximum number of steps, and of inputs.</summary>
    public const int MaxEntries = 100;

    /// <summary>Maximum number of words of a command.</summary>
    public const int MaxWords = 200;

    /// <summary>Maximum length of a word, characters.</summary>
    public const int MaxWordLength = 1000;

    private const int Version = 1;

    /// <summary>Reads a recipe.</summary>
    /// <exception cref="DatasetFormatException">It is invalid.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static DatasetRecipe Read(string path)
    {
        try
        {
            using JsonDocument document = JsonInput.Read(path);
            var fields = new JsonFields(document.RootElement);
            fields.AllowOnly("version", "tool", "inputs", "steps");
            if (fields.Integer("version") is not Version and var version)
            {
                throw new DatasetFormatException($"version must be {Version}, not {version}.");
            }

            RecipeInput[] inputs = fields.Has("inputs") ? [.. Entries(fields, "inputs").Select(InputOf)] : [];
            RecipeStep[] steps = [.. Entries(fields, "steps").Select(StepOf)];
            if (steps.Length == 0)
            {
                throw new DatasetFormatException("steps is empty.");
            }

            string[] names = [.. inputs.Select(input => input.Name), .. steps.Select(step => step.Folder)];
            return names.GroupBy(name => name, StringComparer.OrdinalIgnoreCase).FirstOrDefault(group => group.Count() > 1) is { } twice
                ? throw new DatasetFormatException($"two entries are named '{twice.Key}'.")
                : new DatasetRecipe(fields.OptionalText("tool"), inputs, steps);
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException($"{path}: {e.Message}", e);
        }
    }

    /// <summary>Writes the recipe, whole or not at all.</summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    public void Write(string path)
    {
        var json = new JsonText(indented: true);
        json.BeginObject().Key("version").Integer(Version);
        if (Tool is not null)
        {
            json.Key("tool").String(Tool);
        }

        json.Key("inputs").BeginArray();
        foreach (RecipeInput input in Inputs)
        {
            WriteDigest(json.BeginObject().Key("name").String(input.Name), input.Sha256).EndObject();
        }

        json.EndArray().Key("steps").BeginArray();
        foreach (RecipeStep step in Steps)
        {
            json.BeginObject().Key("folder").String(step.Folder).Key("command").BeginArray();
            foreach (string word in step.Command)
            {
                json.String(word);
            }

            WriteDigest(json.EndArray(), step.Sha256).EndObject();
        }

        AtomicFile.Write(path, json.EndArray().EndObject() + "\n");
    }

    private static JsonText WriteDigest(JsonText json, string? sha256) => sha256 is null ? json : json.Key("sha256").String(sha256);

    private static IReadOnlyList<JsonFields> Entries(JsonFields fields, string name)
    {
        IReadOnlyList<JsonFields> entries = fields.List(name);
        return entries.Count <= MaxEntries
            ? entries
            : throw new DatasetFormatException($"{name} has {entries.Count} entries, more than {MaxEntries}.");
    }

    private static RecipeInput InputOf(JsonFields fields)
    {
        fields.AllowOnly("name", "sha256");
        return new RecipeInput(NameOf(fields, "name"), DigestOf(fields));
    }

    private static RecipeStep StepOf(JsonFields fields)
    {
        fields.AllowOnly("folder", "command", "sha256");
        string folder = NameOf(fields, "folder");
        string[] command = fields.Texts("command");
        return command.Length is 0 or > MaxWords || command.Any(word => word.Length is 0 or > MaxWordLength)
            ? throw new DatasetFormatException(
                $"the command of '{folder}' must have 1 to {MaxWords} words of 1 to {MaxWordLength} characters."
            )
            : new RecipeStep(folder, command, DigestOf(fields));
    }

    private static string NameOf(JsonFields fields, string field)
    {
        string name = fields.Text(field);
        return Name().IsMatch(name)
            ? name
            : throw new DatasetFormatException(
                $"{field} '{name}' must be 1 to 50 letters, digits, underscores and hyphens, and begin with a letter or digit."
            );
    }

    private static string? DigestOf(JsonFields fields) =>
        fields.OptionalText("sha256") is not { } digest ? null
        : Digest().IsMatch(digest) ? digest
        : throw new DatasetFormatException($"sha256 '{digest}' is not 64 hexadecimal digits in lower case.");

    [GeneratedRegex(@"^[A-Za-z0-9][A-Za-z0-9_-]{0,49}\z")]
    private static partial Regex Name();

    [GeneratedRegex(@"^[0-9a-f]{64}\z")]
    private static partial Regex Digest();
}
