using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using Harvester.Datasets.Files;
using Harvester.Datasets.Json;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Sharding;

/// <summary>Puts the shards of a session together: the same bytes as one run without shards gives.</summary>
public static class SessionMerger
{
    /// <summary>Whether a folder holds a session or a shard of one.</summary>
    public static bool IsSession(string folder) => File.Exists(Path.Combine(folder, SessionInfo.FileName));

    /// <summary>Merges.</summary>
    /// <param name="shards">Folders of the shards, in any order.</param>
    /// <param name="folder">Where the session goes: a new or empty folder.</param>
    /// <param name="transfer">How pictures get from the shards into the session.</param>
    /// <returns>The number of frames.</returns>
    /// <exception cref="DatasetFormatException">A shard is missing, unfinished, twice there, or of another session.</exception>
    /// <exception cref="OccupiedFolderException">The folder is not empty.</exception>
    /// <exception cref="IOException">Something cannot be read or written.</exception>
    public static int Merge(IReadOnlyList<string> shards, string folder, ImageTransfer transfer)
    {
        if (Directory.Exists(folder) && Directory.EnumerateFileSystemEntries(folder).Any())
        {
            throw new OccupiedFolderException($"'{folder}' is not empty. Name another folder.");
        }

        IReadOnlyList<SessionShard> sources = Find(shards);
        Directory.CreateDirectory(folder);
        int frames = 0;
        AtomicFile.Write(Path.Combine(folder, SessionReader.LabelsFile), file =>
        {
            using var lines = new StreamWriter(file, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
            foreach ((string line, SessionReader source) in InOrder(sources))
            {
                lines.WriteLine(line);
                foreach (string name in FilesOf(line, frames, source))
                {
                    Place(folder, name, source, transfer);
                }

                PlaceIfThere(folder, FramePaths.Scene(frames), source, transfer);
                frames++;
            }
        });
        foreach (string name in (string[])[FramePaths.Faces, FramePaths.Roads])
        {
            PlaceIfThere(folder, name, sources[0].Session, transfer);
        }

        sources[0].WriteWholeHeader(folder, frames);
        return frames;
    }

    private static void PlaceIfThere(string folder, string name, SessionReader source, ImageTransfer transfer)
    {
        if (File.Exists(source.PathOf(name)))
        {
            Place(folder, name, source, transfer);
        }
    }

    private static void Place(string folder, string name, SessionReader source, ImageTransfer transfer)
    {
        string target = InnerPath.Of(folder, name);
        Directory.CreateDirectory(Path.GetDirectoryName(target)!);
        FileTransfer.Place(target, source.PathOf(name), transfer);
    }

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
                throw new DatasetFormatException($"'{folder}' and '{folders[0]}' are shards of different sessions: their {SessionInfo.FileName} differ.");
            }

            found.Add(shard.Shard, folder, shard);
        }

        return found.Complete();
    }

    // Frames go round: frame f is the next of shard f modulo their number, until all have come to their end.
    private static IEnumerable<(string Line, SessionReader Source)> InOrder(IReadOnlyList<SessionShard> shards)
    {
        List<IEnumerator<string>> lines = [.. shards.Select(shard => shard.ReadLines().GetEnumerator())];
        try
        {
            int frame = 0;
            for (; lines[frame % lines.Count].MoveNext(); frame++)
            {
                SessionReader source = shards[frame % lines.Count].Session;
                string line = lines[frame % lines.Count].Current;
                yield return line.StartsWith(string.Create(CultureInfo.InvariantCulture, $"{{\"frame\":{frame},"), StringComparison.Ordinal)
                    ? (line, source)
                    : throw new DatasetFormatException($"'{source.Folder}' lacks frame {frame}; it is truncated or was changed.");
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
            names = [fields.Text("image"), fields.OptionalText("mask")];
        }
        catch (Exception e) when (e is JsonException or DatasetFormatException)
        {
            throw new DatasetFormatException($"'{source.Folder}', frame {frame}: the label is damaged. Run 'harvester validate'.", e);
        }

        return names.OfType<string>().FirstOrDefault(name => !source.IsWithin(name)) is { } outside
            ? throw new DatasetFormatException($"'{source.Folder}', frame {frame}: '{outside}' points out of the session.")
            : names.OfType<string>();
    }
}
