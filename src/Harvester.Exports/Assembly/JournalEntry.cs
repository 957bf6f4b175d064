using System.Text.Json;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Assembly;

/// <summary>A line of a journal: a finished frame.</summary>
/// <param name="Frame">Number of the frame in the dataset.</param>
/// <param name="Split">The split of the frame.</param>
/// <param name="Labels">Number of labels.</param>
/// <param name="Posts">Number of labels of posts whose faces or heads are exported instead.</param>
/// <param name="Written">Number of labels written.</param>
/// <param name="Files">The files of the frame, with their digests.</param>
/// <param name="Parts">Its parts of aggregate files, in the order of writing.</param>
internal sealed record JournalEntry(
    int Frame,
    string Split,
    int Labels,
    int Posts,
    WrittenObjects Written,
    IReadOnlyList<KeyValuePair<string, FileDigest>> Files,
    IReadOnlyList<KeyValuePair<string, string>> Parts
)
{
    public string ToLine() =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("frame", Frame);
            json.WriteString("split", Split);
            json.WriteNumber("labels", Labels);
            json.WriteNumber("posts", Posts);
            json.WriteNumber("objects", Written.Objects);
            json.WriteNumber("ignored", Written.Ignored);
            json.WriteStartArray("files");
            foreach ((string file, FileDigest digest) in Files)
            {
                json.WriteStartObject();
                json.WriteString("path", file);
                json.WriteNumber("bytes", digest.Bytes);
                json.WriteString("sha256", digest.Sha256);
                json.WriteEndObject();
            }

            json.WriteEndArray();
            json.WriteStartArray("parts");
            foreach ((string name, string line) in Parts)
            {
                json.WriteStringValue(name);
                json.WriteStringValue(line);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        });

    /// <summary>Reads a line.</summary>
    /// <param name="line">The line.</param>
    /// <param name="path">The journal.</param>
    /// <exception cref="DatasetFormatException">The line is damaged, or of another version.</exception>
    public static JournalEntry Parse(string line, string path)
    {
        try
        {
            return Parse(line);
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException(
                $"'{path}' has a damaged line or one of another version. Delete the folder of the dataset, or name another, and export "
                    + "again.",
                e
            );
        }
    }

    private static JournalEntry Parse(string line)
    {
        using JsonDocument document = JsonInput.Parse(line);
        var entry = new JsonFields(document.RootElement);
        string[] parts = entry.Texts("parts");
        return new JournalEntry(
            entry.Integer("frame"),
            entry.Text("split"),
            entry.Integer("labels"),
            entry.Integer("posts"),
            new WrittenObjects(entry.Integer("objects"), entry.Integer("ignored")),
            [.. entry.List("files").Select(file => KeyValuePair.Create(file.Text("path"), ManifestParser.DigestOf(file)))],
            parts.Length % 2 == 0
                ? [.. parts.Chunk(2).Select(pair => KeyValuePair.Create(pair[0], pair[1]))]
                : throw new DatasetFormatException("parts must be pairs of a name and a line.")
        );
    }
}
