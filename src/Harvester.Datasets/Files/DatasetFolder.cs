using System;
using System.IO;
using System.Linq;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Files;

/// <summary>
/// The folder of a dataset. While it is made, a working folder beside the data holds the plan and the journals; when all is done it is
/// gone and export.json is there. Every file appears whole or not at all.
/// </summary>
internal sealed class DatasetFolder(string path)
{
    /// <summary>Says what the dataset is; only a finished dataset has it.</summary>
    public const string Manifest = "export.json";

    /// <summary>The working folder.</summary>
    public const string Working = ".export";

    /// <summary>Where files lie that become parts of others.</summary>
    public const string Staging = Working + "/staged";

    private const string PlanFile = Working + "/plan.json";

    public string Path => path;

    public bool IsFinished => File.Exists(PathOf(Manifest)) && !IsBegun;

    /// <summary>Whether it is finished, but was stopped before the working folder was gone.</summary>
    public bool HasLeftovers => IsFinished && Directory.Exists(PathOf(Working));

    /// <summary>Whether nothing is there yet, a working folder that another shard is about to write its plan to apart.</summary>
    public bool IsEmpty =>
        !Directory.Exists(path) || Directory.EnumerateFileSystemEntries(path).All(entry => System.IO.Path.GetFileName(entry) == Working);

    public bool IsBegun => File.Exists(PathOf(PlanFile));

    /// <exception cref="DatasetFormatException">The name leads out of the dataset.</exception>
    public string PathOf(string name) => InnerPath.Of(path, name);

    public string ReadPlan() =>
        IsBegun ? InputFile.ReadAllText(PathOf(PlanFile))
        : throw new DatasetFormatException(
            IsFinished ? $"'{path}' is a complete dataset, not a shard." : $"'{path}' is not a shard of an export: it has no {PlanFile}.");

    /// <summary>Refuses a folder to which an export can write nothing, whatever its plan.</summary>
    /// <exception cref="OccupiedFolderException">The folder holds a finished dataset or something else.</exception>
    public void CheckUsable()
    {
        if (!HasLeftovers)
        {
            CheckUnfinished();
            CheckUnoccupied();
        }
    }

    /// <summary>Refuses a folder with a finished dataset.</summary>
    /// <exception cref="OccupiedFolderException">The folder holds one.</exception>
    public void CheckUnfinished()
    {
        if (IsFinished)
        {
            throw new OccupiedFolderException($"'{path}' already holds a finished dataset. Name another folder.");
        }
    }

    /// <summary>Begins a dataset, or goes on with one that has the same plan.</summary>
    public void Begin(string plan)
    {
        CheckUnoccupied();
        if (!IsBegun)
        {
            // Of shards that begin at once, the first to be done writes the plan of all.
            AtomicFile.TryWriteNew(Prepare(PlanFile), plan);
        }

        if (!string.Equals(ReadPlan(), plan, StringComparison.Ordinal))
        {
            throw new OccupiedFolderException($"'{path}' holds an export with other sessions or options. Use the same ones, or name another folder.");
        }
    }

    /// <summary>Takes away the working folder and what stopped exports left: when the plan is gone, the dataset is finished.</summary>
    public void Finish()
    {
        DeleteLeftovers();
        File.Delete(PathOf(PlanFile));
        Directory.Delete(PathOf(Working), recursive: true);
    }

    public void Write(string name, Action<Stream> write) => AtomicFile.Write(Prepare(name), write);

    public void Transfer(string name, string source, ImageTransfer transfer) => FileTransfer.Place(Prepare(name), source, transfer);

    // Before the end this would take away the files that other shards write just now.
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
            throw new OccupiedFolderException($"'{path}' is not empty and holds no unfinished export. Name another folder.");
        }
    }

    private string Prepare(string name)
    {
        string target = PathOf(name);
        Directory.CreateDirectory(System.IO.Path.GetDirectoryName(target)!);
        return target;
    }
}
