using System.IO.Compression;
using System.IO.Enumeration;
using Harvester.Datasets.Roads.Ipl;
using Harvester.Datasets.Roads.JsonDump;
using Harvester.Datasets.Roads.Scene;
using Harvester.Datasets.Roads.Sources;
using Harvester.Datasets.Roads.Ynd;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>
/// Reads a road network from a file, a folder or a zip archive. The format is detected from the content of the files, not from their names;
/// files may be gzip-compressed.
/// </summary>
public static class RoadImporter
{
    /// <summary>Largest total size of the files of a folder or archive, bytes unpacked.</summary>
    private const long MaxImportBytes = 2L << 30;

    /// <summary>Reads a road network.</summary>
    /// <param name="path">A file, a folder, or a zip archive.</param>
    /// <param name="lanesIn">Direction of the "lanes in" of paths.ipl and paths.xml; the other formats define it.</param>
    /// <exception cref="DatasetFormatException">The format is unknown or a file is invalid; the message names the place.</exception>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public static RoadImport Import(string path, LanesIn lanesIn = LanesIn.Forward) => Import(path, lanesIn, MaxImportBytes);

    /// <summary>As <see cref="Import(string, LanesIn)"/>, with another limit of the total size, bytes unpacked.</summary>
    internal static RoadImport Import(string path, LanesIn lanesIn, long largest)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        try
        {
            return ImportAny(path, lanesIn, new ByteAllowance(largest));
        }
        catch (InvalidDataException e)
        {
            throw new DatasetFormatException($"{path}: the compressed data is corrupt: {e.Message}", e);
        }
    }

    private static RoadImport ImportAny(string path, LanesIn lanesIn, ByteAllowance allowance)
    {
        if (Directory.Exists(path))
        {
            return Import(
                path,
                lanesIn,
                [
                    .. InOrder(FilesIn(path))
                        .Select(name => new RoadSource(name, allowance, () => InputFile.OpenRead(InnerPath.Of(path, name)))),
                ]
            );
        }

        if (!IsZip(path))
        {
            return Import(path, lanesIn, [new RoadSource(Path.GetFileName(path), allowance, () => InputFile.OpenRead(path))]);
        }

        using var archive = new ZipArchive(InputFile.OpenRead(path));
        Dictionary<string, ZipArchiveEntry> entries = archive
            .Entries.Where(entry => entry.Length > 0)
            .GroupBy(entry => entry.FullName, StringComparer.Ordinal)
            .ToDictionary(same => same.Key, same => same.First());
        return Import(path, lanesIn, [.. InOrder(entries.Keys).Select(name => new RoadSource(name, allowance, entries[name].Open))]);
    }

    /// <summary>The files of a folder and its sub-folders. Links to folders are not followed, because they may form a cycle.</summary>
    private static FileSystemEnumerable<string> FilesIn(string folder)
    {
        var options = new EnumerationOptions
        {
            RecurseSubdirectories = true,
            AttributesToSkip = FileAttributes.None,
            IgnoreInaccessible = false,
        };
        return new FileSystemEnumerable<string>(
            folder,
            (ref FileSystemEntry entry) => Path.GetRelativePath(folder, entry.ToFullPath()).Replace(Path.DirectorySeparatorChar, '/'),
            options
        )
        {
            ShouldIncludePredicate = (ref FileSystemEntry entry) => !entry.IsDirectory,
            ShouldRecursePredicate = (ref FileSystemEntry entry) => (entry.Attributes & FileAttributes.ReparsePoint) == 0,
        };
    }

    /// <summary>Names of files, those in sub-folders last; of two files with the same cell, the later one counts.</summary>
    private static IOrderedEnumerable<string> InOrder(IEnumerable<string> names) =>
        names.OrderBy(name => name.Count(letter => letter == '/')).ThenBy(name => name, StringComparer.Ordinal);

    private static RoadImport Import(string path, LanesIn lanesIn, IReadOnlyList<RoadSource> sources)
    {
        var cells = new List<RoadSource>();
        foreach (RoadSource source in sources)
        {
            string head = source.Head().TrimStart();
            if (YndImporter.Understands(head))
            {
                cells.Add(source);
            }
            else if (cells.Count == 0 && ImporterOf(head, lanesIn) is { } import)
            {
                return import(source);
            }
        }

        return cells.Count > 0
            ? YndImporter.Import(cells)
            : throw new DatasetFormatException(
                $"{path}: unknown road format. Supported: *.ynd.xml, paths.ipl, paths.xml, the JSON dump of nodes, and this project's "
                    + "CSV."
            );
    }

    private static Func<RoadSource, RoadImport>? ImporterOf(string head, LanesIn lanesIn) =>
        JsonDumpImporter.Understands(head) ? JsonDumpImporter.Import
        : head.StartsWith('<') ? source => SceneImporter.Import(source, lanesIn)
        : head.StartsWith(RoadCsv.FirstLine, StringComparison.Ordinal) ? CsvImporter.Import
        : IplImporter.Understands(head) ? source => IplImporter.Import(source, lanesIn)
        : null;

    private static bool IsZip(string path)
    {
        byte[] magic = new byte[4];
        using FileStream stream = InputFile.OpenRead(path);
        return stream.ReadAtLeast(magic, magic.Length, throwOnEndOfStream: false) == magic.Length && magic is [(byte)'P', (byte)'K', 3, 4];
    }
}
