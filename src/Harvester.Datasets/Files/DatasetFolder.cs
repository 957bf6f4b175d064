using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Files;

/// <summary>
/// The folder of a dataset. During an export, a working folder has the plan and the journals. When all frames are done, export.json is
/// written and the working folder is deleted. Every file is written atomically; <see cref="Flush"/> waits for the disk.
/// </summary>
internal sealed class DatasetFolder(string path, SyncMode sync = SyncMode.Batch)
{
    /// <summary>Name of the file that says what was exported, which only a finished dataset has.</summary>
    public const string Header = "export.json";

    /// <summary>Name of the file that describes the dataset to its users.</summary>
    public const string Readme = "README.md";

    /// <summary>Name of the working folder.</summary>
    public const string Working = ".export";

    /// <summary>Folder of files that become parts of others.</summary>
    public const string Staging = Working + "/staged";

    private const string PlanFile = Working + "/plan.json";

    private readonly SyncBatch _written = new();
    private readonly HashSet<string> _known = new(StringComparer.Ordinal);

    public string Path => path;

    /// <summary>When written files are flushed to the disk.</summary>
    public SyncMode Sync => sync;

    /// <summary>Whether files that were flushed survive a loss of power.</summary>
    public bool IsDurable => sync != SyncMode.Never;

    public bool IsFinished => File.Exists(PathOf(Header)) && !IsBegun;

    /// <summary>Whether the dataset is finished, but its working folder still exists.</summary>
    public bool HasLeftovers => IsFinished && Directory.Exists(PathOf(Working));

    /// <summary>
    /// Whether the folder is new or empty, apart from a working folder in which another shard is about to write the plan.
    /// </summary>
    public bool IsEmpty =>
        !Directory.Exists(path) || Directory.EnumerateFileSystemEntries(path).All(entry => System.IO.Path.GetFileName(entry) == Working);

    public bool IsBegun => File.Exists(PathOf(PlanFile));

    /// <exception cref="DatasetFormatException">The name points outside the dataset.</exception>
    public string PathOf(string name) => InnerPath.Of(path, name);

    public string ReadPlan() =>
        IsBegun
            ? InputFile.ReadAllText(PathOf(PlanFile))
            : throw new DatasetFormatException(
                IsFinished
                    ? $"'{path}' is a complete dataset, not a shard."
                    : $"'{path}' is not a shard of an export: it has no {PlanFile}."
            );

    /// <summary>Refuses a folder to which no export can be written, whatever its plan.</summary>
    /// <exception cref="OccupiedFolderException">The folder has a finished dataset or other files.</exception>
    public void CheckUsable()
    {
        if (!HasLeftovers)
        {
            CheckUnfinished();
            CheckUnoccupied();
        }
    }

    /// <summary>Refuses a folder with a finished dataset.</summary>
    /// <exception cref="OccupiedFolderException">The folder has a finished dataset.</exception>
    public void CheckUnfinished()
    {
        if (IsFinished)
        {
            throw new OccupiedFolderException($"'{path}' already has a finished dataset. Name another folder with --out.");
        }
    }

    /// <summary>Starts an export, or resumes one with the same plan. What follows is written only after the plan is on the disk.</summary>
    public void Begin(string plan)
    {
        CheckUnoccupied();
        if (!IsBegun)
        {
            // If several shards start at once, the first one writes the plan.
            AtomicFile.TryWriteNew(Prepare(PlanFile), plan, IsDurable);
        }

        if (!string.Equals(ReadPlan(), plan, StringComparison.Ordinal))
        {
            throw new OccupiedFolderException(
                $"'{path}' has an export with other sessions or options. Use the same ones, or name another folder."
            );
        }

        AddFolder(System.IO.Path.GetDirectoryName(System.IO.Path.TrimEndingDirectorySeparator(System.IO.Path.GetFullPath(path))) ?? path);
        Flush();
    }

    /// <summary>Deletes the working folder and leftovers of stopped exports. Once the plan is deleted, the dataset is finished.</summary>
    public void Finish()
    {
        DeleteLeftovers();
        File.Delete(PathOf(PlanFile));
        Directory.Delete(PathOf(Working), recursive: true);
        AddFolder(path);
        Flush();
    }

    /// <summary>
    /// Deletes the temporary files that stopped exports of a shard left: those of its files, and those of the plan, which is there now.
    /// </summary>
    /// <param name="names">The files of the shard, which no other shard writes.</param>
    public void DeleteLeftoversOf(IEnumerable<string> names)
    {
        foreach (
            IGrouping<string, string> files in names.Append(PlanFile).Select(PathOf).GroupBy(path => System.IO.Path.GetDirectoryName(path)!)
        )
        {
            var targets = files.Select(path => System.IO.Path.GetFileName(path)).ToHashSet(StringComparer.Ordinal);
            AtomicFile.DeleteLeftovers(files.Key, targets.Contains);
        }
    }

    /// <summary>Writes a file, in place of an older one.</summary>
    /// <returns>Its digest.</returns>
    public FileDigest Write(string name, Action<Stream> write)
    {
        FileDigest digest = default;
        string target = Prepare(name);
        AtomicFile.Write(target, stream => digest = DigestStream.Write(stream, write), isDurable: false);
        Add(target);
        return digest;
    }

    /// <summary>Places a file of a session or of another shard.</summary>
    public void Transfer(string name, string source, ImageTransfer transfer)
    {
        string target = Prepare(name);
        FileTransfer.Place(target, source, transfer);
        Add(target);
    }

    /// <summary>Takes a file that is there already among those to be brought to the disk.</summary>
    public void Keep(string name) => Add(PathOf(name));

    /// <summary>Waits until all files written so far are on the disk; does nothing with <see cref="SyncMode.Never"/>.</summary>
    /// <exception cref="IOException">The disk reported an error; the files may or may not be on it.</exception>
    public void Flush() => _written.Flush();

    // Earlier, this would delete files that other shards are writing.
    private void DeleteLeftovers()
    {
        var options = new EnumerationOptions { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.ReparsePoint };
        foreach (string folder in Directory.EnumerateDirectories(path, "*", options).Append(path))
        {
            AtomicFile.DeleteLeftovers(folder, _ => true);
        }
    }

    private void CheckUnoccupied()
    {
        if (!IsEmpty && !IsBegun)
        {
            throw new OccupiedFolderException($"'{path}' is not empty and has no unfinished export. Name another folder.");
        }
    }

    /// <summary>The path of a file in a folder that is there. A folder's name is brought to the disk with the first file in it.</summary>
    private string Prepare(string name)
    {
        string target = PathOf(name);
        string folder = System.IO.Path.GetDirectoryName(target)!;
        Directory.CreateDirectory(folder);
        for (string each = folder; each.Length > path.Length && _known.Add(each); each = System.IO.Path.GetDirectoryName(each)!)
        {
            AddFolder(System.IO.Path.GetDirectoryName(each)!);
        }

        return target;
    }

    private void Add(string file)
    {
        if (IsDurable)
        {
            _written.Add(file);
        }
    }

    private void AddFolder(string folder)
    {
        if (IsDurable)
        {
            _written.AddFolder(folder);
        }
    }
}
