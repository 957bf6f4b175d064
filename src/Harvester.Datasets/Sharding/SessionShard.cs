using System.Collections.Generic;
using System.Text.Json.Nodes;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Sharding;

/// <summary>A finished shard of a session.</summary>
/// <param name="Session">The shard, which is a session of its own.</param>
/// <param name="Shard">Which it is.</param>
/// <param name="Common">What its session.json says of the whole session, the same in all shards.</param>
internal sealed record SessionShard(SessionReader Session, Shard Shard, string Common)
{
    private const string Complete = "complete";

    /// <summary>Reads one.</summary>
    /// <exception cref="DatasetFormatException">The folder holds no shard, or one that did not come to its end.</exception>
    public static SessionShard Read(string folder)
    {
        var session = new SessionReader(folder);
        SessionHeader header = SessionHeader.Read(session);
        Shard shard = header.Shard ?? throw new DatasetFormatException($"'{folder}' is a complete session, not a shard.");
        if (header.Json["state"]?.ToString() != Complete || session.HasUnfinishedLine)
        {
            throw new DatasetFormatException($"Shard {shard} in '{folder}' is not finished. Run it again.");
        }

        return new SessionShard(session, shard, Whole(header, 0));
    }

    /// <summary>The lines of its labels.</summary>
    public IEnumerable<string> ReadLines() => Session.ReadTexts();

    /// <summary>Writes the session.json of the whole session.</summary>
    public void WriteWholeHeader(string folder, int frames)
    {
        SessionHeader header = SessionHeader.Read(Session);
        Whole(header, frames);
        header.Write(folder);
    }

    private static string Whole(SessionHeader header, int frames)
    {
        header.Shard = null;
        if (header.Json["counters"] is JsonObject counters)
        {
            counters["captured"] = frames;
        }

        return header.ToString();
    }
}
