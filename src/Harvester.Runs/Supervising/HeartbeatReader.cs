using System.Globalization;
using System.Text.Json;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Runs.Supervising;

/// <summary>
/// Reads heartbeat.json, which another program writes and may damage. A link, a pipe or a device is not opened, and no more is read than a
/// heartbeat can have.
/// </summary>
public static class HeartbeatReader
{
    /// <summary>Name of the file in the output folder.</summary>
    public const string FileName = "heartbeat.json";

    private const int MaxBytes = 64 * 1024;
    private const int MaxTrialCharacters = 256;

    /// <summary>Reads the file.</summary>
    /// <param name="path">The file, which may be missing.</param>
    public static HeartbeatReading Read(string path)
    {
        byte[] bytes = [];
        try
        {
            bytes = Bytes(path);
            return new HeartbeatReading(bytes, Parse(bytes), null);
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            return HeartbeatReading.Missing;
        }
        catch (JsonException)
        {
            return new HeartbeatReading(bytes, null, "It is not JSON.");
        }
        catch (Exception e) when (e is DatasetFormatException or IOException or UnauthorizedAccessException)
        {
            return new HeartbeatReading(bytes, null, e.Message);
        }
    }

    private static byte[] Bytes(string path)
    {
        if (new FileInfo(path).LinkTarget is not null)
        {
            throw new IOException("It is a link, which is not followed.");
        }

        // The program may replace or delete the file meanwhile.
        using FileStream file = RegularFile.OpenRead(path, FileShare.ReadWrite | FileShare.Delete);
        byte[] bytes = new byte[MaxBytes + 1];
        int count = file.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false);
        return count <= MaxBytes
            ? bytes[..count]
            : throw new DatasetFormatException(FormattableString.Invariant($"It has more than {MaxBytes} bytes."));
    }

    private static SeenHeartbeat Parse(byte[] bytes)
    {
        using JsonDocument document = JsonInput.Parse(bytes);
        var fields = new JsonFields(document.RootElement);
        return new SeenHeartbeat(
            fields.Integer("process"),
            TimeOf(fields.Text("time")),
            fields.Name<HeartbeatState>("state"),
            TrialOf(document.RootElement),
            fields.LongInteger("frames") is >= 0 and var frames ? frames : throw new DatasetFormatException("The field frames is negative.")
        );
    }

    private static DateTime TimeOf(string text) =>
        DateTimeOffset.TryParse(
            text,
            CultureInfo.InvariantCulture,
            DateTimeStyles.AssumeUniversal | DateTimeStyles.AdjustToUniversal,
            out DateTimeOffset time
        )
            ? time.UtcDateTime
            : throw new DatasetFormatException("The field time is not a time.");

    private static string TrialOf(JsonElement root)
    {
        string trial = root.TryGetProperty("trial", out JsonElement value) && value.ValueKind != JsonValueKind.Null ? value.ToString() : "";
        return trial.Length <= MaxTrialCharacters ? trial : trial[..MaxTrialCharacters];
    }
}
