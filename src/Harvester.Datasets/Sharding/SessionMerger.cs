using System.Globalization;
using System.Text.Json;
using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenarios;

namespace Harvester.Datasets.Sharding;

/// <summary>Merges the shards of a session; the result is byte-identical to that of a single run.</summary>
public static class SessionMerger
{
    /// <summary>Whether a folder is a session or a shard of one.</summary>
    public static bool IsSession(string folder) => File.Exists(Path.Combine(folder, SessionInfo.FileName));

    /// <summary>Merges shards.</summary>
    /// <param name="shards">Folders of the shards, in any order.</param>
    /// <param name="folder">Folder to write the session to: new, empty, or with what a stopped merge left that is resumed.</param>
    /// <param name="options">How they are merged.</param>
    /// <returns>The number of frames.</returns>
    /// <exception cref="DatasetFormatException">A shard is missing, unfinished, given twice, or of another session.</exception>
    /// <exception cref="OccupiedFolderException">The folder is not empty.</exception>
    /// <exception cref="IOException">Something cannot be read or written.</exception>
    public static int Merge(IReadOnlyList<string> shards, string folder, MergeOptions options)
    {
        if (Directory.Exists(folder) && !UnfinishedMark.IsAllOf(folder) && !(options.Resume && UnfinishedMark.IsIn(folder)))
        {
            throw new OccupiedFolderException($"'{folder}' is not empty. Name another folder.");
        }

        IReadOnlyList<SessionShard> sources = Find(shards);
        var digests = new Dictionary<SessionReader, CarriedDigests>();
        int frames = 0;
        try
        {
            foreach (SessionShard shard in sources)
            {
                digests.Add(shard.Session, new CarriedDigests(shard.Session));
            }

            NewSession.Write(
                folder,
                options.Sync,
                WorkKey.Of(sources.Select(shard => shard.Session), ["merge"]),
                options.Resume,
                options.MinFreeBytes,
                session => frames = PlaceAll(session, sources, digests, options),
                () => sources[0].WholeHeader(frames)
            );
            return frames;
        }
        finally
        {
            foreach (CarriedDigests each in digests.Values)
            {
                each.Dispose();
            }
        }
    }

    /// <summary>The number of frames in a finished merge of these shards.</summary>
    /// <param name="shards">Folders of the shards, in any order.</param>
    /// <param name="folder">The folder.</param>
    /// <returns>Null if the folder has no such result: its session.json or the number of its labels differs.</returns>
    /// <exception cref="DatasetFormatException">As for <see cref="Merge"/>.</exception>
    /// <exception cref="IOException">Something cannot be read.</exception>
    public static int? FramesOfFinished(IReadOnlyList<string> shards, string folder)
    {
        if (!IsSession(folder) || UnfinishedMark.IsIn(folder))
        {
            return null;
        }

        IReadOnlyList<SessionShard> sources = Find(shards);
        int frames = sources.Sum(shard => shard.Session.CountLines());
        return
            InputFile.ReadAllText(Path.Combine(folder, SessionInfo.FileName)) == sources[0].WholeHeader(frames)
            && new SessionReader(folder).CountLines() == frames
            ? frames
            : null;
    }

    private static int PlaceAll(
        NewSession session,
        IReadOnlyList<SessionShard> sources,
        Dictionary<SessionReader, CarriedDigests> digests,
        MergeOptions options
    )
    {
        int frames = 0;
        int views = sources[0].Session.ReadInfo().Rig?.Cameras.Count ?? 1;
        foreach ((string line, SessionReader source) in InOrder(sources, views))
        {
            options.Cancellation.ThrowIfCancellationRequested();
            if (frames < session.Resumed)
            {
                frames++;
                continue;
            }

            foreach (string name in FilesOf(line, frames, source).Concat(IfThere(FramePaths.Scene(frames), source)))
            {
                int frame = frames;
                session.Place(name, source, options.Transfer, () => digests[source].Of(frame, name));
            }

            session.EndFrame(frames, line);
            frames++;
        }

        SessionReader first = sources[0].Session;
        CheckEvents(sources);
        foreach (
            string name in ((string[])[FramePaths.Faces, FramePaths.Roads, FramePaths.Events, ScenarioRecord.FileName]).SelectMany(name =>
                IfThere(name, first)
            )
        )
        {
            session.Place(name, first, options.Transfer, () => digests[first].Of(name));
        }

        return frames;
    }

    /// <summary>Every shard has the events of the whole session.</summary>
    private static void CheckEvents(IReadOnlyList<SessionShard> sources)
    {
        FileDigest?[] events =
        [
            .. sources
                .Select(shard => shard.Session.PathOf(FramePaths.Events))
                .Select(path => File.Exists(path) ? FileDigest.OfFile(path) : (FileDigest?)null),
        ];
        if (Array.FindIndex(events, each => each != events[0]) is var other and > 0)
        {
            throw new DatasetFormatException(
                $"'{sources[other].Session.Folder}' and '{sources[0].Session.Folder}' have different {FramePaths.Events}, which each "
                    + "shard has of the whole session. Run 'harvester validate', and harvest the damaged one again."
            );
        }
    }

    private static IEnumerable<string> IfThere(string name, SessionReader source) => File.Exists(source.PathOf(name)) ? [name] : [];

    private static IReadOnlyList<SessionShard> Find(IReadOnlyList<string> folders)
    {
        var found = new ShardSet<SessionShard>();
        SessionShard? first = null;
        foreach (string folder in folders)
        {
            SessionShard shard = SessionShard.Read(folder);
            first ??= shard;
            if (shard.Common != first.Common)
            {
                throw new DatasetFormatException(
                    $"'{folder}' and '{folders[0]}' are shards of different sessions: their {SessionInfo.FileName} differ."
                );
            }

            found.Add(shard.Shard, folder, shard);
        }

        return found.Complete();
    }

    // Frame f, or moment m of a rig, is the next of shard f modulo the number of shards, until all shards have ended.
    private static IEnumerable<(string Line, SessionReader Source)> InOrder(IReadOnlyList<SessionShard> shards, int views)
    {
        List<IEnumerator<string>> lines = [.. shards.Select(shard => shard.ReadLines().GetEnumerator())];
        try
        {
            int frame = 0;
            for (; lines[frame / views % lines.Count].MoveNext(); frame++)
            {
                int shard = frame / views % lines.Count;
                SessionReader source = shards[shard].Session;
                string line = lines[shard].Current;
                yield return line.StartsWith(string.Create(CultureInfo.InvariantCulture, $"{{\"frame\":{frame},"), StringComparison.Ordinal)
                    ? (line, source)
                    : throw new DatasetFormatException($"'{source.Folder}' has no frame {frame}; it is truncated or was changed.");
            }

            if (lines.FindIndex(each => each.MoveNext()) is var longer and >= 0)
            {
                throw new DatasetFormatException($"'{shards[longer].Session.Folder}' has frames after frame {frame}, which no shard has.");
            }
        }
        finally
        {
            lines.ForEach(each => each.Dispose());
        }
    }

    private static IEnumerable<string> FilesOf(string line, int frame, SessionReader source)
    {
        string?[] names;
        try
        {
            using JsonDocument label = JsonInput.Parse(line);
            var fields = new JsonFields(label.RootElement);
            names =
            [
                fields.Text("image"),
                fields.OptionalText("mask"),
                .. FrameChannels.All.Where(channel => fields.Has(channel.Key)).SelectMany(channel => channel.Read(fields)?.Files ?? []),
            ];
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException($"'{source.Folder}', frame {frame}: the label is damaged. Run 'harvester validate'.", e);
        }

        return names.OfType<string>().FirstOrDefault(name => !source.IsWithin(name)) is { } outside
            ? throw new DatasetFormatException($"'{source.Folder}', frame {frame}: '{outside}' points outside the session.")
            : names.OfType<string>();
    }
}
