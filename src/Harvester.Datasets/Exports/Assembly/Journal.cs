using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Exports.Assembly;

/// <summary>
/// The frames that one shard has done, a line each, by rising number. A frame is part of the dataset when its line is complete; half a line
/// is what a killed export leaves, and is taken away when the export goes on. The last line of a finished shard says so.
/// </summary>
internal sealed class Journal : IDisposable
{
    private const string EndMark = "end";

    private readonly FileStream _file;

    /// <summary>Opens a shard's journal to go on with it.</summary>
    public Journal(DatasetFolder folder, Shard shard)
    {
        string path = PathOf(folder, shard);
        _file = new FileStream(path, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.Read);
        long end = 0;
        LastFrame = -1;
        using var reader = new StreamReader(_file, Encoding.UTF8, leaveOpen: true);
        string text;
        while ((text = ReadTo(reader)).EndsWith('\n'))
        {
            end += Encoding.UTF8.GetByteCount(text);
            if (text.StartsWith(EndMark, StringComparison.Ordinal))
            {
                IsEnded = true;
            }
            else
            {
                LastFrame = JournalEntry.Parse(text, path).Frame;
                Frames++;
            }
        }

        _file.SetLength(end);
        _file.Seek(end, SeekOrigin.Begin);
    }

    /// <summary>The last frame that is done; -1 for none.</summary>
    public int LastFrame { get; private set; }

    /// <summary>Frames that are done.</summary>
    public int Frames { get; private set; }

    /// <summary>Whether the shard is done.</summary>
    public bool IsEnded { get; private set; }

    public static string PathOf(DatasetFolder folder, Shard shard) => folder.PathOf(string.Create(
        CultureInfo.InvariantCulture, $"{DatasetFolder.Working}/journal-{shard.Number}-of-{shard.Count}.jsonl"));

    /// <summary>The shards of which a folder holds journals.</summary>
    public static IEnumerable<Shard> ShardsIn(DatasetFolder folder)
    {
        foreach (string name in Directory.EnumerateFiles(folder.PathOf(DatasetFolder.Working), "journal-*-of-*.jsonl")
            .Select(Path.GetFileNameWithoutExtension).OfType<string>())
        {
            string[] words = name.Split('-');
            yield return (words is [_, var number, _, var count] ? ShardText.Parse($"{number}/{count}") : null)
                ?? throw new DatasetFormatException($"'{folder.Path}' has a journal '{name}' of no shard. Delete it, or begin the export anew.");
        }
    }

    /// <summary>Whether a shard's journal says that the shard is done.</summary>
    public static bool IsComplete(string path) =>
        InputFile.ReadLines(path).LastOrDefault()?.StartsWith(EndMark, StringComparison.Ordinal) == true;

    /// <summary>The frames of a finished shard.</summary>
    public static IEnumerable<JournalEntry> Read(string path) =>
        InputFile.ReadLines(path).Where(line => !line.StartsWith(EndMark, StringComparison.Ordinal))
            .Select(line => JournalEntry.Parse(line, path));

    public void Append(JournalEntry entry)
    {
        AppendLine(entry.ToLine());
        LastFrame = entry.Frame;
        Frames++;
    }

    public void End()
    {
        if (!IsEnded)
        {
            AppendLine(EndMark);
            IsEnded = true;
        }
    }

    public void Dispose() => _file.Dispose();

    private void AppendLine(string line)
    {
        _file.Write(Encoding.UTF8.GetBytes(line + "\n"));
        _file.Flush();
    }

    /// <summary>A line with its end, or what is left without one.</summary>
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
        }

        return line.ToString();
    }
}
