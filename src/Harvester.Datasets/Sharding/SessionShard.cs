using System.Text.Json.Nodes;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Sharding;

/// <summary>A finished shard of a session.</summary>
/// <param name="Session">The shard, which is a session itself.</param>
/// <param name="Shard">Its number.</param>
/// <param name="Common">The content of session.json that all shards share.</param>
internal sealed record SessionShard(SessionReader Session, Shard Shard, string Common)
{
    private const string Complete = "complete";

    /// <summary>Opens a shard.</summary>
    /// <exception cref="DatasetFormatException">The folder is not a shard, or the shard is unfinished.</exception>
    public static SessionShard Read(string folder)
    {
        var session = new SessionReader(folder);
        SessionHeader header = SessionHeader.Read(session);
        Shard shard = header.Shard ?? throw new DatasetFormatException($"'{folder}' is a complete session, not a shard. Leave it out.");
        if (
            header.Json["state"]?.ToString() != Complete
            || session.HasUnfinishedLine
            || File.Exists(Path.Combine(folder, UnfinishedMark.FileName))
        )
        {
            throw new DatasetFormatException($"Shard {shard} in '{folder}' is not finished. Run it again.");
        }

        return new SessionShard(session, shard, Whole(header, 0));
    }

    /// <summary>The lines of its label file.</summary>
    public IEnumerable<string> ReadLines() => Session.ReadTexts();

    /// <summary>The session.json of the whole session.</summary>
    public string WholeHeader(int frames) => Whole(SessionHeader.Read(Session), frames);

    private static string Whole(SessionHeader header, int frames)
    {
        header.Shard = null;
        header.SetManifest();
        if (header.Json["counters"] is JsonObject counters)
        {
            counters["captured"] = frames;
        }

        return header.ToString();
    }
}
