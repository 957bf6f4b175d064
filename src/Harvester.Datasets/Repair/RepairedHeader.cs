using System.Text.Json.Nodes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Repair;

/// <summary>The session.json of a repaired session: the damaged session's as far as it can be read.</summary>
internal sealed class RepairedHeader
{
    private readonly SessionHeader? _read;

    private RepairedHeader(SessionHeader? read, string? problem)
    {
        _read = read;
        Problem = problem;
    }

    /// <summary>What is wrong with the file; null for nothing.</summary>
    public string? Problem { get; }

    /// <summary>Size of the images; null if it is not known.</summary>
    public ImageSize? Image { get; private init; }

    /// <summary>What it says of the session; null if it cannot be read.</summary>
    public SessionInfo? Info { get; private init; }

    private static string Tool => $"harvester {typeof(RepairedHeader).Assembly.GetName().Version!.ToString(3)}";

    /// <summary>Reads the session.json of a damaged session.</summary>
    /// <param name="session">The session.</param>
    /// <param name="digests">What the manifest says the file may be; empty for nothing.</param>
    public static RepairedHeader Read(SessionReader session, IReadOnlyList<FileDigest> digests)
    {
        string path = session.PathOf(SessionInfo.FileName);
        if (!File.Exists(path))
        {
            return new RepairedHeader(null, "it is missing; game, options and lens are lost.");
        }

        byte[] bytes = InputFile.ReadAllBytes(path);
        bool isIntact = digests.Count == 0;
        foreach (FileDigest digest in digests)
        {
            isIntact |= digest == FileDigest.Of(bytes, bytes.Length);
        }

        string? problem = null;
        if (!isIntact)
        {
            byte[]? corrected = BitRepair.Try(bytes, digests);
            problem = corrected is not null
                ? "one flipped bit was corrected."
                : $"its SHA-256 differs from {Manifest.FileName}; its values may be wrong.";
            bytes = corrected ?? bytes;
        }

        try
        {
            SessionInfo info = SessionInfo.Parse(bytes);
            return new RepairedHeader(SessionHeader.Parse(bytes), problem) { Image = info.Image, Info = info };
        }
        catch (DatasetFormatException e)
        {
            return new RepairedHeader(null, $"it is damaged ({e.Message.TrimEnd('.')}); game, options and lens are lost.");
        }
    }

    /// <summary>The text of the new file.</summary>
    /// <param name="frames">Frames of the new session.</param>
    /// <param name="lost">Frames that were lost.</param>
    /// <param name="image">Size of the images.</param>
    /// <param name="format">Format of the images, as session.json names it.</param>
    public string Text(int frames, int lost, ImageSize image, string format)
    {
        SessionHeader header =
            _read
            ?? SessionHeader.Of(
                new JsonObject
                {
                    ["formatVersion"] = 1,
                    ["tool"] = Tool,
                    ["game"] = "unknown",
                    ["seed"] = null,
                    ["settings"] = new JsonObject(),
                    ["image"] = new JsonObject
                    {
                        ["width"] = image.Width,
                        ["height"] = image.Height,
                        ["format"] = format,
                        ["quality"] = null,
                    },
                }
            );
        JsonObject json = header.Json;
        if (json["settings"] is JsonObject settings)
        {
            settings["repairedBy"] = Tool;
        }

        bool isClosed = json["state"]?.ToString() is "complete" or "faulted";
        if (_read is null || !isClosed || lost > 0)
        {
            json["state"] = "faulted";
            json["fault"] = lost > 0 ? $"{Counted.Of(lost, "frame")} lost to damage" : "the recording was cut off";
        }

        header.SetManifest();
        if (json["counters"] is JsonObject counters)
        {
            counters["captured"] = frames;
        }
        else
        {
            json["counters"] = new JsonObject { ["captured"] = frames };
        }

        return header.ToString();
    }
}
