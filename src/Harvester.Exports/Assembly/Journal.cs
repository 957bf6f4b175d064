using System.Diagnostics;
using System.Globalization;
using System.Text;
using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Assembly;

/// <summary>
/// The finished frames of a shard, one line each, by ascending number. A frame is part of the dataset when its line is complete. Lines are
/// held back until the files of a batch of frames are on the disk. When a killed export resumes, an incomplete line is removed, and so is
/// everything from the first frame on whose files are not as its line says. The last line of a finished shard says so.
/// </summary>
internal sealed class Journal : IDisposable
{
    private const string EndMark = "end";

    private readonly DatasetFolder _folder;
    private readonly FileStream _file;
    private readonly List<string> _held = [];
    private readonly Stopwatch _age = new();

    /// <summary>Opens the journal of a shard to append to it.</summary>
    public Journal(DatasetFolder folder, Shard shard)
    {
        string path = PathOf(folder, shard);
        _folder = folder;
        _file = AppendedFile.Open(path, FileAccess.ReadWrite);
        folder.Keep(NameOf(shard));
        _file.Seek(0, SeekOrigin.Begin);
        long end = 0;
        LastFrame = -1;
        using var reader = new StreamReader(_file, Encoding.UTF8, leaveOpen: true);
        string text;
        while ((text = ReadTo(reader)).EndsWith('\n'))
        {
            if (text.StartsWith(EndMark, StringComparison.Ordinal))
            {
                IsEnded = true;
            }
            else if (JournalEntry.Parse(text, path) is var entry && FinishedFrame.AreWhole(folder.Path, entry.Files))
            {
                LastFrame = entry.Frame;
                Frames++;
            }
            else
            {
                // The frame is exported again, and so is what follows, since lines are in order.
                break;
            }

            end += Encoding.UTF8.GetByteCount(text);
        }

        _file.SetLength(end);
        _file.Seek(end, SeekOrigin.Begin);
    }

    /// <summary>The last frame, also of those whose lines are held back; -1 for none.</summary>
    public int LastFrame { get; private set; }

    /// <summary>Number of frames, including those whose lines are held back.</summary>
    public int Frames { get; private set; }

    /// <summary>Whether the shard is finished.</summary>
    public bool IsEnded { get; private set; }

    public static string PathOf(DatasetFolder folder, Shard shard) => folder.PathOf(NameOf(shard));

    /// <summary>The shards whose journals are in a folder.</summary>
    public static IEnumerable<Shard> ShardsIn(DatasetFolder folder)
    {
        foreach (
            string name in Directory
                .EnumerateFiles(folder.PathOf(DatasetFolder.Working), "journal-*-of-*.jsonl")
                .Select(Path.GetFileNameWithoutExtension)
                .OfType<string>()
        )
        {
            string[] words = name.Split('-');
            yield return (words is [_, var number, _, var count] ? ShardText.Parse($"{number}/{count}") : null)
                ?? throw new DatasetFormatException(
                    $"'{folder.Path}' has a journal '{name}' that belongs to no shard. Delete it, or delete the folder and export again."
                );
        }
    }

    /// <summary>Refuses a folder that has shards of an export that is divided otherwise.</summary>
    /// <exception cref="OccupiedFolderException">It has.</exception>
    public static void CheckDivision(DatasetFolder folder, Shard shard)
    {
        if (folder.IsBegun && ShardsIn(folder).FirstOrDefault(other => other.Count != shard.Count) is { Count: > 0 } other)
        {
            string whole = other.Count == 1 ? "the unfinished export of all frames" : $"shard {other}";
            string asked = shard.Count == 1 ? "all frames go" : $"shard {shard} goes";
            throw new OccupiedFolderException($"'{folder.Path}' has {whole}, so {asked} to another folder. Name another with --out.");
        }
    }

    /// <summary>Whether the journal of a shard says that it is finished.</summary>
    public static bool IsComplete(string path) =>
        InputFile.ReadLines(path).LastOrDefault()?.StartsWith(EndMark, StringComparison.Ordinal) == true;

    /// <summary>The frames of a finished shard.</summary>
    public static IEnumerable<JournalEntry> Read(string path) =>
        InputFile
            .ReadLines(path)
            .Where(line => !line.StartsWith(EndMark, StringComparison.Ordinal))
            .Select(line => JournalEntry.Parse(line, path));

    /// <summary>Takes a frame whose files are written, and writes its line when it is due.</summary>
    /// <exception cref="IOException">The disk refuses.</exception>
    public void Append(JournalEntry entry)
    {
        if (_held.Count == 0)
        {
            _age.Restart();
        }

        _held.Add(entry.ToLine());
        LastFrame = entry.Frame;
        Frames++;
        if (_folder.Sync != SyncMode.Batch || _held.Count >= SyncBatch.MaxFrames || _age.Elapsed >= SyncBatch.MaxAge)
        {
            Commit();
        }
    }

    /// <summary>
    /// Writes the lines held back. After a failure their frames are given up: a disk that could not keep a file does not say so twice.
    /// </summary>
    /// <exception cref="IOException">The disk refuses.</exception>
    public void Commit()
    {
        string[] lines = [.. _held];
        _held.Clear();
        _folder.Flush();
        if (lines.Length > 0)
        {
            AppendedFile.AppendLines(_file, lines, _folder.IsDurable);
        }
    }

    /// <summary>Writes the line that says that the shard is finished.</summary>
    /// <exception cref="IOException">The disk refuses.</exception>
    public void End()
    {
        if (!IsEnded)
        {
            Commit();
            AppendedFile.AppendLines(_file, [EndMark], _folder.IsDurable);
            IsEnded = true;
        }
    }

    public void Dispose() => _file.Dispose();

    private static string NameOf(Shard shard) =>
        string.Create(CultureInfo.InvariantCulture, $"{DatasetFolder.Working}/journal-{shard.Number}-of-{shard.Count}.jsonl");

    /// <summary>A line with its line feed, or the rest without one.</summary>
    private static string ReadTo(StreamReader reader)
    {
        var line = new StringBuilder();
        for (int c = reader.Read(); c >= 0; c = reader.Read())
        {
            line.Append((char)c);
            if (c == '\n')
            {
                break;
            }

            if (line.Length > InputFile.MaxLineCharacters)
            {
                throw new DatasetFormatException(
                    $"A journal of the export has a line of more than {InputFile.MaxLineCharacters} characters. "
                        + "Delete the folder, and export again."
                );
            }
        }

        return line.ToString();
    }
}
