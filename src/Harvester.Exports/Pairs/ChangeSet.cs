using System.Globalization;
using System.Text.Json;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Pairs;

/// <summary>A folder of sessions of one situation: a base, and runs in which one thing was changed; see docs/counterfactuals.md.</summary>
/// <param name="Changes">The changed runs, in the order of their folders.</param>
public sealed record ChangeSet(IReadOnlyList<ChangedRun> Changes)
{
    /// <summary>Name of the file that describes a set.</summary>
    public const string FileName = "counterfactuals.json";

    /// <summary>Folder of the base session.</summary>
    public const string Base = "base";

    /// <summary>Maximum number of changed runs.</summary>
    public const int MaxChanges = 99;

    private const int Version = 1;

    /// <summary>Name of the folder of a changed run.</summary>
    /// <param name="number">Its number, from 1.</param>
    public static string FolderOf(int number) => "change-" + number.ToString("D2", CultureInfo.InvariantCulture);

    /// <summary>Whether a folder has a set.</summary>
    public static bool IsIn(string folder) => File.Exists(Path.Combine(folder, FileName));

    /// <summary>Reads the description of a set.</summary>
    /// <exception cref="DatasetFormatException">It is invalid.</exception>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static ChangeSet Read(string folder)
    {
        string path = Path.Combine(folder, FileName);
        try
        {
            using JsonDocument document = JsonInput.Read(path);
            var fields = new JsonFields(document.RootElement);
            fields.AllowOnly("version", "base", "changes");
            if (fields.Integer("version") != Version || fields.Text("base") != Base)
            {
                throw new DatasetFormatException($"version must be {Version} and base '{Base}'.");
            }

            IReadOnlyList<JsonFields> changes = fields.List("changes");
            if (changes.Count is 0 or > MaxChanges)
            {
                throw new DatasetFormatException($"changes has {changes.Count} entries instead of 1 to {MaxChanges}.");
            }

            return new ChangeSet([.. changes.Select(RunOf)]);
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException($"{path}: {e.Message}", e);
        }
    }

    /// <summary>Writes the description into the folder of the set.</summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    public void Write(string folder)
    {
        JsonText json = new JsonText(indented: true).BeginObject().Key("version").Integer(Version).Key("base").String(Base).Key("changes");
        json.BeginArray();
        foreach (ChangedRun run in Changes)
        {
            json.BeginObject().Key("folder").String(run.Folder).Key("change").String(run.Change).EndObject();
        }

        AtomicFile.Write(Path.Combine(folder, FileName), json.EndArray().EndObject() + "\n");
    }

    private static ChangedRun RunOf(JsonFields fields, int index)
    {
        fields.AllowOnly("folder", "change");
        string folder = fields.Text("folder");
        return folder == FolderOf(index + 1)
            ? new ChangedRun(folder, fields.Text("change"))
            : throw new DatasetFormatException($"folder {index + 1} must be '{FolderOf(index + 1)}', not '{folder}'.");
    }
}
