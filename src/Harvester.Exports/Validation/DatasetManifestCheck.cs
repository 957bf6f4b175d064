using System.Buffers.Binary;
using System.Security.Cryptography;
using System.Text;
using Harvester.Datasets.Files;
using Harvester.Datasets.Validation;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Validation;

/// <summary>Compares a dataset with its manifest: every file is there and is what the manifest says, and no other is among them.</summary>
/// <param name="folder">Folder of the dataset.</param>
/// <param name="files">Number of files in the manifest by export.json; null for a dataset of an earlier version.</param>
internal sealed class DatasetManifestCheck(string folder, int? files)
{
    // Lines in memory at once: enough to keep the processors busy.
    private const int ChunkLength = 64;

    // A path of 4,096 bytes, each escaped, and the other fields.
    private const int MaxLineCharacters = 32_000;

    // Of each, up to two checksums are held: 500 MB.
    private const int MaxFiles = 10_000_000;

    private readonly HashSet<ulong> _listed = [];
    private readonly HashSet<ulong> _kinds = [];
    private readonly List<string> _otherFiles = [];

    /// <summary>Whether there is a manifest.</summary>
    public bool IsThere { get; } = File.Exists(Path.Combine(folder, Manifest.FileName));

    /// <summary>Files that the manifest does not list and that are of no kind that it lists in their folder.</summary>
    public IReadOnlyList<string> OtherFiles => _otherFiles;

    /// <summary>Adds the problems of all files that have none so far.</summary>
    /// <exception cref="DatasetFormatException">A line of the manifest is too long.</exception>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public void AddProblems(ProblemList problems, CancellationToken cancellation)
    {
        if (!IsThere)
        {
            if (files is not null)
            {
                problems.Add(new SessionProblem(Manifest.FileName, null, $"it is missing, but {DatasetFolder.Header} counts its files."));
            }

            return;
        }

        var known = problems.Select(problem => problem.File).ToHashSet(StringComparer.Ordinal);
        bool isWhole = AddDamage(problems, known, cancellation);
        if (files is { } counted && isWhole && _listed.Count != counted)
        {
            isWhole = false;
            problems.Add(
                new SessionProblem(Manifest.FileName, null, $"it lists {_listed.Count} files, but {DatasetFolder.Header} counts {counted}.")
            );
        }

        // A manifest that has lost lines does not tell which files are too many.
        if (isWhole && !problems.IsFull)
        {
            AddUnlisted(problems, cancellation);
        }
    }

    /// <summary>Compares the files that the manifest lists, on all processors.</summary>
    /// <returns>Whether all its lines could be read.</returns>
    private bool AddDamage(ProblemList problems, HashSet<string> known, CancellationToken cancellation)
    {
        bool isWhole = true;
        int number = 0;
        foreach (string[] chunk in InputFile.ReadLines(Path.Combine(folder, Manifest.FileName), MaxLineCharacters).Chunk(ChunkLength))
        {
            foreach ((string? path, string? problem) in ParallelCheck.Each(chunk, ProblemOf, cancellation))
            {
                number++;
                if (path is null)
                {
                    isWhole = false;
                    problems.Add(new SessionProblem(Manifest.FileName, number, problem!));
                    continue;
                }

                _listed.Add(ChecksumOf(path));
                if (path != DatasetFolder.Readme)
                {
                    _kinds.Add(KindOf(path));
                }

                if (problem is not null && !known.Contains(path))
                {
                    problems.Add(new SessionProblem(path, null, problem));
                }
            }

            if (problems.IsFull)
            {
                return false;
            }

            if (number > MaxFiles)
            {
                problems.Add(
                    new SessionProblem(
                        Manifest.FileName,
                        null,
                        $"it lists more than {MaxFiles} files, the limit; later ones are not compared."
                    )
                );
                return false;
            }
        }

        return isWhole;
    }

    /// <summary>The file that a line lists, with its problem if it has one; for a damaged line, only its problem.</summary>
    private (string? Path, string? Problem) ProblemOf(string line)
    {
        string path;
        FileDigest digest;
        try
        {
            (path, digest) = ManifestParser.File(line);
        }
        catch (DatasetFormatException e)
        {
            return (null, e.Message);
        }

        try
        {
            string file = InnerPath.Of(folder, path);
            return (
                path,
                !File.Exists(file) ? $"it is missing, but listed in {Manifest.FileName}."
                : DigestCheck.Problem(file, [digest]) is { } damage ? $"it {damage}"
                : null
            );
        }
        catch (DatasetFormatException e)
        {
            return (path, e.Message);
        }
    }

    private void AddUnlisted(ProblemList problems, CancellationToken cancellation)
    {
        var options = new EnumerationOptions { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.ReparsePoint };
        List<string> unlisted = [];
        foreach (string file in Directory.EnumerateFiles(folder, "*", options))
        {
            cancellation.ThrowIfCancellationRequested();
            string name = Path.GetRelativePath(folder, file).Replace('\\', '/');
            if (name != Manifest.FileName && !_listed.Contains(ChecksumOf(name)) && unlisted.Count <= ProblemList.MaxProblems)
            {
                unlisted.Add(name);
            }
        }

        unlisted.Sort(StringComparer.Ordinal);
        foreach (string name in unlisted)
        {
            if (_kinds.Contains(KindOf(name)))
            {
                problems.Add(
                    new SessionProblem(
                        name,
                        null,
                        $"it is not listed in {Manifest.FileName}, but readers take it for a part of the dataset. Delete it."
                    )
                );
            }
            else
            {
                _otherFiles.Add(name);
            }
        }
    }

    /// <summary>
    /// Stands for a path in a tenth of its memory. That two of a million files have the same has a probability of 3e-8; a file too many
    /// would go unnoticed then.
    /// </summary>
    private static ulong ChecksumOf(string path) => BinaryPrimitives.ReadUInt64LittleEndian(SHA256.HashData(Encoding.UTF8.GetBytes(path)));

    /// <summary>Folder and ending: readers find files by listing a folder and by their endings.</summary>
    private static ulong KindOf(string path) => ChecksumOf($"{Path.GetDirectoryName(path)}/*{Path.GetExtension(path).ToUpperInvariant()}");
}
