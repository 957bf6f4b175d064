using System;
using System.IO;
using System.Text;
using Harvester.Capture.Labelling;
using Harvester.Sessions.Files;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Storage;

/// <summary>What a session directory already holds, as far as resuming the session needs it.</summary>
/// <param name="Header">The text of session.json; null if there is no such file.</param>
/// <param name="Frames">Frames with a label line.</param>
/// <param name="MaxObjectId">The greatest object id in use; 0 if there are no objects.</param>
/// <param name="HasManifest">Whether there is a manifest; sessions of earlier versions have none.</param>
internal sealed record SessionContent(string? Header, int Frames, int MaxObjectId, bool HasManifest)
{
    public static SessionContent Nothing { get; } = new(null, 0, 0, false);

    /// <summary>Reads a directory. An unfinished last line is cut off, so that the next one starts a line.</summary>
    public static SessionContent Read(string directory)
    {
        string header = Path.Combine(directory, SessionDirectory.Header);
        string labels = Path.Combine(directory, SessionDirectory.Labels);
        int frames = 0;
        int maxId = 0;
        if (File.Exists(labels))
        {
            CutAfterLastLine(labels);
            foreach (string line in File.ReadLines(labels, Encoding.UTF8))
            {
                frames++;
                maxId = Math.Max(maxId, MaxIdIn(line));
            }
        }

        return new SessionContent(
            File.Exists(header) ? File.ReadAllText(header, Encoding.UTF8) : null,
            frames,
            maxId,
            File.Exists(Path.Combine(directory, Manifest.FileName)));
    }

    /// <summary>Whether a session with this header can be resumed under another one: both are equal up to the start of a run.</summary>
    public bool IsContinuedBy(string header) => Header is null || Settings(Header) == Settings(header);

    private static string Settings(string header)
    {
        int end = header.IndexOf(SessionJson.RunsBegin, StringComparison.Ordinal);
        return end < 0 ? header : header.Substring(0, end);
    }

    /// <summary>The greatest object id in a label line; in a damaged line, that in the part before the damage.</summary>
    private static int MaxIdIn(string line)
    {
        int maxId = 0;
        var json = new JsonReader(line);
        try
        {
            json.Object(field => ReadIf(json, field == "objects", () => json.List(() =>
                json.Object(name => ReadIf(json, name == "id", () => maxId = Math.Max(maxId, ObjectId(json)))))));
        }
        catch (FormatException)
        {
            // Frames that follow a damaged one are still worth recording; harvester validate reports the damage.
        }

        return maxId;
    }

    private static int ObjectId(JsonReader json)
    {
        double id = json.Number();
        return id is >= 0 and <= ObjectRegistry.MaxId ? (int)id : throw json.Wrong("an object number out of range");
    }

    private static void ReadIf(JsonReader json, bool isWanted, Action read)
    {
        if (isWanted)
        {
            read();
        }
        else
        {
            json.Skip();
        }
    }

    private static void CutAfterLastLine(string file)
    {
        using FileStream stream = AppendedFile.Open(file, FileAccess.ReadWrite);
        long end = stream.Length;
        for (; end > 0; end--)
        {
            stream.Position = end - 1;
            if (stream.ReadByte() == '\n')
            {
                break;
            }
        }

        if (end < stream.Length)
        {
            stream.SetLength(end);
        }
    }
}
