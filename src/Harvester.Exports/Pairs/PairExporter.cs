using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Exports.Pairs;

/// <summary>
/// Exports the pictures of moments, grouped by moment. Every file is written whole; the tables, which name all others, come last.
/// </summary>
/// <param name="session">The session.</param>
/// <param name="format">The form of the export.</param>
/// <param name="transfer">Whether pictures are linked or copied, for <see cref="PairFormat.Csv"/>.</param>
/// <param name="sync">When to wait for the disk.</param>
public sealed class PairExporter(SessionReader session, PairFormat format, ImageTransfer transfer, SyncMode sync)
{
    /// <summary>Folder of the pictures.</summary>
    internal const string Images = "images";

    private readonly SyncBatch _written = new();
    private readonly HashSet<string> _placed = new(StringComparer.Ordinal);

    /// <summary>Whether what an earlier run of the same command has written whole may stay.</summary>
    public bool Resumes { get; init; }

    /// <summary>Deletes what an export that was stopped left in a folder; a mark stays.</summary>
    /// <exception cref="IOException">Something cannot be deleted.</exception>
    /// <exception cref="UnauthorizedAccessException">Something may not be deleted.</exception>
    public static void Clear(string folder)
    {
        foreach (string file in Directory.GetFiles(folder).Where(path => IsOwn(Path.GetFileName(path))))
        {
            File.Delete(file);
        }

        if (Directory.Exists(Path.Combine(folder, Images)))
        {
            Directory.Delete(Path.Combine(folder, Images), recursive: true);
        }
    }

    /// <summary>Deletes the tables and temporary files that an export that was stopped left; what else it wrote stays.</summary>
    /// <exception cref="IOException">Something cannot be deleted, or a folder is a link.</exception>
    /// <exception cref="UnauthorizedAccessException">Something may not be deleted.</exception>
    public static void ClearTables(string folder)
    {
        foreach (
            string file in Directory
                .GetFiles(folder)
                .Where(path => IsOwn(Path.GetFileName(path)) && !PairArchives.IsName(Path.GetFileName(path)))
        )
        {
            File.Delete(file);
        }

        string images = Path.Combine(folder, Images);
        if (Directory.Exists(images))
        {
            AppendedFile.RefuseLink(images);
            foreach (string group in Directory.GetDirectories(images))
            {
                AppendedFile.RefuseLink(group);
            }
        }
    }

    /// <summary>Whether a folder has nothing but an export whose last file is written.</summary>
    public static bool IsFinished(string folder) => File.Exists(Path.Combine(folder, PairTables.Index)) && ForeignIn(folder) is null;

    /// <summary>The name of something in a folder that is no part of an export; null if there is none.</summary>
    public static string? ForeignIn(string folder) =>
        Directory
            .EnumerateFileSystemEntries(folder)
            .Select(Path.GetFileName)
            .FirstOrDefault(name => name != Images && !IsOwn(name!) && !UnfinishedMark.Is(name!));

    /// <summary>What a finished export of this session in this form has; null if a folder has none.</summary>
    /// <param name="folder">The folder.</param>
    /// <exception cref="DatasetFormatException">A label is invalid.</exception>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public PairExport? Finished(string folder)
    {
        bool hasForm =
            Directory.Exists(folder)
            && (
                format == PairFormat.Webdataset
                    ? Directory.EnumerateFiles(folder).Any(path => PairArchives.IsName(Path.GetFileName(path)))
                    : Directory.Exists(Path.Combine(folder, Images))
            );
        if (!hasForm || UnfinishedMark.IsIn(folder) || !IsFinished(folder))
        {
            return null;
        }

        // The table of objects has every label of every moment, whatever the form.
        using var objects = new StringWriter();
        PairExport done = new(0, 0, 0);
        using (var tables = new PairTables(TextWriter.Null, objects))
        {
            foreach (LabelLine line in session.ReadGoodLines().Where(line => line.Label!.Pairs.Count > 0))
            {
                var group = PairGroup.Of(line);
                tables.Add(group, image => image.Name);
                done = done.With(group);
            }
        }

        return FileDigest.OfFile(Path.Combine(folder, PairTables.Objects)) == FileDigest.Of(objects.ToString()) ? done : null;
    }

    /// <summary>Writes the export.</summary>
    /// <param name="folder">The folder, which has nothing but its mark and what may stay of an earlier run.</param>
    /// <param name="report">Receives the number of frames after each frame.</param>
    /// <param name="cancellation">Stops between two frames.</param>
    /// <exception cref="DatasetFormatException">The session has no further pictures, or a label or picture is invalid.</exception>
    /// <exception cref="IOException">A file cannot be read or written.</exception>
    public PairExport Run(string folder, Action<int> report, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(report);
        using var archives = new PairArchives(folder, file => Written(file)) { Resumes = Resumes };
        var done = new PairExport(0, 0, 0);
        using var index = new StringWriter();
        using var objects = new StringWriter();
        using (var tables = new PairTables(index, objects))
        {
            var keys = new HashSet<string>(StringComparer.Ordinal);
            int frames = 0;
            foreach (LabelLine line in session.ReadGoodLines())
            {
                cancellation.ThrowIfCancellationRequested();
                if (line.Label!.Pairs.Count > 0)
                {
                    var group = PairGroup.Of(line);
                    if (!keys.Add(group.Key))
                    {
                        throw new DatasetFormatException($"Two frames have the number {line.Label.Frame}. Run 'harvester validate'.");
                    }

                    string? archive = format == PairFormat.Webdataset ? archives.Add(group, session) : null;
                    tables.Add(group, image => archive is null ? Placed(folder, group, image) : $"{archive}/{group.Key}.{image.Name}");
                    done = done.With(group);
                }

                report(++frames);
            }
        }

        if (done.Groups == 0)
        {
            throw new DatasetFormatException(
                $"'{session.Folder}' has no further pictures of its moments. "
                    + "Harvest with --pair-weathers, --pair-hours or --pair-without."
            );
        }

        archives.End();
        if (Resumes)
        {
            archives.DeleteHigher();
            DeleteOthers(Path.Combine(folder, Images));
        }

        WriteTable(Path.Combine(folder, PairTables.Objects), objects);
        WriteTable(Path.Combine(folder, PairTables.Index), index);
        if (sync != SyncMode.Never)
        {
            _written.AddFolder(folder);
            _written.Flush();
        }

        return done;
    }

    private static bool IsOwn(string name) =>
        (AtomicFile.TargetOf(name) ?? name) is var target
        && (target is PairTables.Index or PairTables.Objects or PairTables.Changes || PairArchives.IsName(target));

    private string Placed(string folder, PairGroup group, PairImage image)
    {
        string name = $"{Images}/{group.Key}/{image.Name}";
        string target = InnerPath.Of(folder, name);
        Directory.CreateDirectory(Path.GetDirectoryName(target)!);
        string source = session.PathOf(image.Path);
        if (!Resumes || !FileTransfer.IsPlaced(target, source))
        {
            FileTransfer.Place(target, source, transfer);
        }

        _placed.Add(Path.GetFullPath(target));
        Written(target);
        return name;
    }

    /// <summary>Deletes pictures of an earlier run that this one has not, and temporary files.</summary>
    private void DeleteOthers(string images)
    {
        if (!Directory.Exists(images))
        {
            return;
        }

        foreach (string group in Directory.GetDirectories(images))
        {
            foreach (string file in Directory.GetFiles(group).Where(file => !_placed.Contains(Path.GetFullPath(file))))
            {
                File.Delete(file);
            }

            if (!Directory.EnumerateFileSystemEntries(group).Any())
            {
                Directory.Delete(group);
            }
        }

        if (!Directory.EnumerateFileSystemEntries(images).Any())
        {
            Directory.Delete(images);
        }
    }

    private void WriteTable(string file, StringWriter text)
    {
        AtomicFile.Write(file, text.ToString(), isDurable: false);
        Written(file);
    }

    private void Written(string file)
    {
        if (sync != SyncMode.Never)
        {
            _written.Add(file);
        }
    }
}
