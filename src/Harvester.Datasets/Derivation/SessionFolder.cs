using System.Text.RegularExpressions;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenarios;

namespace Harvester.Datasets.Derivation;

/// <summary>What belongs to a session in its folder, by name. Everything else is somebody's own and is never deleted.</summary>
public static class SessionFolder
{
    /// <summary>Name of a session's report when none is given.</summary>
    public const string Report = "report.html";

    private static readonly string[] Files =
    [
        SessionInfo.FileName,
        SessionReader.LabelsFile,
        Manifest.FileName,
        FramePaths.Events,
        Report,
        SessionJournal.FileName,
        ScenarioRecord.FileName,
    ];
    private static readonly IReadOnlyList<string> Folders = FrameChannels.Folders;
    private static readonly string[] Common = [Path.GetFileName(FramePaths.Faces), Path.GetFileName(FramePaths.Roads)];
    private static readonly Regex FrameFile = new(@"\A[0-9]{8,}\.(png|bmp|jpg|json|bin)\z", RegexOptions.CultureInvariant);

    private static readonly Regex PairFile = new(
        @"\A[a-z]+(-[0-9]{2})?(-without-[A-Za-z0-9-]{1,60})?\.(png|bmp|jpg)\z",
        RegexOptions.CultureInvariant
    );

    private static readonly Regex View = new(@"\A[A-Za-z0-9][A-Za-z0-9_-]{0,39}\z", RegexOptions.CultureInvariant);

    /// <summary>The path within a folder of something that is no part of a session; null if there is none.</summary>
    /// <exception cref="IOException">The folder cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder cannot be read.</exception>
    public static string? ForeignIn(string folder)
    {
        foreach (string entry in Directory.EnumerateFileSystemEntries(folder))
        {
            string name = Path.GetFileName(entry);
            if (Folders.Contains(name) && Directory.Exists(entry))
            {
                if (ForeignInSubfolder(entry) is { } inner)
                {
                    return $"{name}/{inner}";
                }
            }
            else if (!IsOwn(name))
            {
                return name;
            }
        }

        return null;
    }

    /// <summary>Deletes the session in a folder, or the part of one. A mark stays.</summary>
    /// <param name="folder">The folder; it need not exist.</param>
    /// <exception cref="IOException">Something cannot be deleted.</exception>
    /// <exception cref="UnauthorizedAccessException">Something may not be deleted.</exception>
    public static void Clear(string folder)
    {
        if (!Directory.Exists(folder))
        {
            return;
        }

        // session.json goes first: without it, the rest is not taken for a session.
        foreach (string file in Files)
        {
            File.Delete(Path.Combine(folder, file));
        }

        foreach (string path in Folders.Select(name => Path.Combine(folder, name)).Where(Directory.Exists))
        {
            Directory.Delete(path, recursive: true);
        }

        AtomicFile.DeleteLeftovers(folder, IsOwn);
        foreach (string path in Directory.GetFiles(folder).Where(path => IsLock(Path.GetFileName(path))))
        {
            File.Delete(path);
        }
    }

    /// <summary>Whether a stopped command has left frames in a folder from which it can be resumed.</summary>
    /// <param name="folder">The folder; it need not exist.</param>
    public static bool HasJournal(string folder) => File.Exists(Path.Combine(folder, SessionJournal.FileName));

    /// <summary>Deletes the notes from which a command could be resumed, because it is complete.</summary>
    /// <param name="folder">The folder.</param>
    /// <exception cref="IOException">They cannot be deleted.</exception>
    /// <exception cref="UnauthorizedAccessException">They may not be deleted.</exception>
    public static void DeleteJournal(string folder) => File.Delete(Path.Combine(folder, SessionJournal.FileName));

    /// <summary>Deletes the session in a folder except for the files of its frames and its journal.</summary>
    /// <param name="folder">The folder.</param>
    /// <exception cref="IOException">Something cannot be deleted.</exception>
    /// <exception cref="UnauthorizedAccessException">Something may not be deleted.</exception>
    internal static void ClearAllButFrames(string folder)
    {
        foreach (string file in Files.Where(file => file != SessionJournal.FileName))
        {
            File.Delete(Path.Combine(folder, file));
        }

        AtomicFile.DeleteLeftovers(folder, IsOwn);
        var options = new EnumerationOptions { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.ReparsePoint };
        foreach (string inner in Directory.EnumerateDirectories(folder, "*", options))
        {
            AtomicFile.DeleteLeftovers(inner, _ => true);
        }
    }

    // A folder that is a link is deleted as a link; what it leads to stays.
    private static string? ForeignInSubfolder(string path) =>
        new FileInfo(path).LinkTarget is not null
            ? null
            : Directory
                .EnumerateFiles(path)
                .Select(Path.GetFileName)
                .OfType<string>()
                .FirstOrDefault(name => TargetOf(name) is var target && !FrameFile.IsMatch(target) && !Common.Contains(target))
                ?? Directory
                    .EnumerateDirectories(path)
                    .Select(view => (Name: Path.GetFileName(view), Inner: ForeignInView(view)))
                    .Where(view => view.Inner is not null)
                    .Select(view => $"{view.Name}/{view.Inner}".TrimEnd('/'))
                    .FirstOrDefault();

    /// <summary>What does not belong into the folder of a view or LiDAR; empty for the folder itself, which has no such name.</summary>
    private static string? ForeignInView(string path) =>
        !View.IsMatch(Path.GetFileName(path)) ? ""
        : new FileInfo(path).LinkTarget is not null ? null
        : Directory
            .EnumerateFileSystemEntries(path)
            .Select(Path.GetFileName)
            .OfType<string>()
            .FirstOrDefault(name =>
                TargetOf(name) is var target
                && !FrameFile.IsMatch(target)
                && !(PairFile.IsMatch(target) && Path.GetFileName(Path.GetDirectoryName(path)) == FramePaths.Pairs)
            );

    private static bool IsOwn(string name) => UnfinishedMark.Is(name) || Files.Contains(TargetOf(name)) || IsLock(TargetOf(name));

    private static bool IsLock(string name) => Files.Any(file => FolderLock.IsOf(name, file));

    private static string TargetOf(string name) => AtomicFile.TargetOf(name) ?? name;
}
