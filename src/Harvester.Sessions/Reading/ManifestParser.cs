using System.Text.Json;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Sessions.Reading;

/// <summary>Reads lines of manifest.jsonl.</summary>
internal static class ManifestParser
{
    /// <summary>Reads the line of a frame.</summary>
    /// <exception cref="DatasetFormatException">The line is damaged.</exception>
    public static ManifestFrame Frame(string line)
    {
        using JsonDocument document = Parse(line);
        var frame = new JsonFields(document.RootElement);
        var files = new Dictionary<string, FileDigest>();
        foreach (JsonFields file in frame.List("files"))
        {
            files[file.Text("path")] = DigestOf(file);
        }

        return new ManifestFrame(frame.Integer("frame"), DigestOf(frame.Fields("label")), files);
    }

    /// <summary>Reads the line of a file that belongs to no single frame.</summary>
    /// <exception cref="DatasetFormatException">The line is damaged.</exception>
    public static (string Path, FileDigest Digest) File(string line)
    {
        using JsonDocument document = Parse(line);
        var file = new JsonFields(document.RootElement);
        return (file.Text("path"), DigestOf(file));
    }

    private static JsonDocument Parse(string line)
    {
        if (!Manifest.IsIntact(line))
        {
            throw new DatasetFormatException("the line is damaged: its checksum does not match.");
        }

        try
        {
            return JsonInput.Parse(line);
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException(JsonFault.InLine(e), e);
        }
    }

    /// <summary>The size and checksum that an object of the manifest or of a journal has.</summary>
    /// <exception cref="DatasetFormatException">A field is missing or damaged.</exception>
    public static FileDigest DigestOf(JsonFields fields) => new(fields.LongInteger("bytes"), fields.Text("sha256"));
}
