using System.Text;
using Harvester.Sessions.Files;

namespace Harvester.Sessions.Plans;

/// <summary>
/// The status file of a plan's output: one JSON object per attempt that has ended. A line is on the disk before the next attempt begins; an
/// unfinished last line, as a loss of power leaves it, is removed.
/// </summary>
public sealed class PlanStatus
{
    private readonly string _path;
    private readonly Dictionary<string, TrialResult> _last = new(StringComparer.Ordinal);

    private PlanStatus(string path) => _path = path;

    /// <summary>The last result of each trial that has one.</summary>
    public IReadOnlyDictionary<string, TrialResult> Last => _last;

    /// <summary>Name of the file of a whole run or of a shard.</summary>
    public static string FileNameOf(Shard shard) =>
        shard.Count == 1 ? "plan-status.jsonl" : FormattableString.Invariant($"plan-status-{shard.Number}-of-{shard.Count}.jsonl");

    /// <summary>Opens the file of a folder; it need not exist.</summary>
    /// <param name="folder">The folder of the plan's output; it must exist.</param>
    /// <param name="shard">The part of the plan.</param>
    /// <exception cref="FormatException">A line is not a result; the message names file and line.</exception>
    /// <exception cref="IOException">The file is a link, or cannot be read.</exception>
    public static PlanStatus Open(string folder, Shard shard)
    {
        var status = new PlanStatus(Path.Combine(folder, FileNameOf(shard)));
        if (File.Exists(status._path))
        {
            using FileStream file = AppendedFile.Open(status._path, FileAccess.ReadWrite);
            status.Read(file);
        }

        return status;
    }

    /// <summary>Number of the next attempt at a trial, from 1; null for a trial that needs none.</summary>
    public int? NextAttempt(string trial) =>
        !_last.TryGetValue(trial, out TrialResult? result) ? 1
        : result.IsLast ? null
        : result.Attempt + 1;

    /// <summary>Adds a result; it is on the disk when this returns.</summary>
    /// <exception cref="IOException">The file cannot be written; it is unchanged.</exception>
    public void Add(TrialResult result)
    {
        bool isNew = !File.Exists(_path);
        using FileStream file = AppendedFile.Open(_path);
        AppendedFile.AppendLines(file, [(result ?? throw new ArgumentNullException(nameof(result))).ToJson()], isDurable: true);
        if (isNew)
        {
            DiskSync.Folder(Path.GetDirectoryName(Path.GetFullPath(_path))!);
        }

        _last[result.Trial] = result;
    }

    private void Read(FileStream file)
    {
        file.Seek(0, SeekOrigin.Begin);
        using var bytes = new MemoryStream();
        file.CopyTo(bytes);
        byte[] content = bytes.ToArray();
        int end = Array.LastIndexOf(content, (byte)'\n') + 1;
        if (end < content.Length)
        {
            file.SetLength(end);
        }

        string[] lines = Encoding.UTF8.GetString(content, 0, end).Split('\n');
        for (int i = 0; i < lines.Length - 1; i++)
        {
            try
            {
                TrialResult result = TrialResult.Parse(lines[i]);
                _last[result.Trial] = result;
            }
            catch (FormatException e)
            {
                throw new FormatException(FormattableString.Invariant($"{Path.GetFileName(_path)}, line {i + 1}: {e.Message}"), e);
            }
        }
    }
}
