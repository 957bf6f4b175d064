using System.Globalization;
using System.Text.RegularExpressions;
using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Datasets.Outputs;
using Harvester.Sessions.Files;

namespace Harvester.Runs.Driving;

/// <summary>
/// A folder with a numbered session for each drive of a command: 0001, 0002 and so on. As a single session, it has a mark until the command
/// is complete, and former sessions stay as they are until the new ones are complete.
/// </summary>
public sealed partial class NumberedSessions : IDisposable
{
    private readonly Action<string> _warn;
    private readonly string _folder;
    private readonly string _command;
    private readonly FolderLock _held;
    private readonly bool _replaces;
    private FolderReplacement? _replacement;
    private string? _written;

    /// <summary>Locks the folder and checks it. Nothing is written before the first session.</summary>
    /// <param name="warn">Receives warnings, one line each.</param>
    /// <param name="folder">The folder.</param>
    /// <param name="command">The command, as its mark names it.</param>
    /// <param name="overwrite">Whether former sessions are replaced.</param>
    /// <exception cref="IOException">A file is where the folder should be.</exception>
    /// <exception cref="OccupiedFolderException">The folder is in use, or has files that must not be replaced.</exception>
    public NumberedSessions(Action<string> warn, string folder, string command, bool overwrite)
    {
        (_warn, _folder, _command) = (warn, folder, command);
        if (OutputFolder.FileInTheWayOf(folder) is { } file)
        {
            throw new IOException($"'{file}' is a file. Name a folder with --record.");
        }

        _held = FolderLock.Take(folder);
        try
        {
            _replaces = Check(overwrite);
        }
        catch
        {
            _held.Dispose();
            throw;
        }
    }

    /// <summary>Number of sessions begun.</summary>
    public int Count { get; private set; }

    /// <summary>Makes room for the next session.</summary>
    public SessionOutput Next()
    {
        _written ??= Begin();
        Count++;
        string name = Count.ToString("D4", CultureInfo.InvariantCulture);
        return new SessionOutput(_warn, Path.Combine(_written, name), _command, overwrite: false, keepsFrames: true);
    }

    /// <summary>Makes the sessions that were written those in the folder.</summary>
    /// <exception cref="IOException">That is impossible; former sessions are as they were.</exception>
    public void Complete()
    {
        DeleteLocksLeft();
        if (_replacement?.Complete() is { } former)
        {
            _warn($"The former sessions are replaced, but their files in '{former}' cannot be deleted. Delete them yourself.");
        }
        else if (_replacement is null && _written is not null)
        {
            UnfinishedMark.Delete(_written);
        }
    }

    /// <summary>Releases the folder. What was written in place stays with its mark unless the command is complete.</summary>
    public void Dispose()
    {
        _replacement?.Dispose();
        _held.Dispose();
    }

    /// <summary>Whether there is something to replace.</summary>
    private bool Check(bool overwrite)
    {
        if (!Directory.Exists(_folder) || UnfinishedMark.IsAllOf(_folder))
        {
            return false;
        }

        if (Directory.EnumerateFileSystemEntries(_folder).FirstOrDefault(entry => !IsOwn(entry)) is { } other)
        {
            throw new OccupiedFolderException(
                $"'{_folder}' has something other than recorded sessions, e.g. '{Path.GetFileName(other)}'. "
                    + "Name another folder with --record."
            );
        }

        string? unfinished = UnfinishedMark.CommandIn(_folder);
        if (unfinished == _command || overwrite)
        {
            return unfinished != _command;
        }

        throw new OccupiedFolderException(
            unfinished is null
                ? $"'{_folder}' already has sessions. Name another folder with --record, or replace them with --overwrite."
                : $"'{_folder}' has the unfinished result of '{OutputFolder.Shown(unfinished)}'. Run that command again, "
                    + "name another folder with --record, or replace it with --overwrite."
        );
    }

    /// <summary>
    /// Deletes locks of finished sessions that could not be deleted before. What cannot be deleted now stays; it locks nothing.
    /// </summary>
    private void DeleteLocksLeft()
    {
        if (_written is null)
        {
            return;
        }

        foreach (string file in Directory.GetFiles(_written).Where(file => Lock().IsMatch(Path.GetFileName(file))))
        {
            try
            {
                File.Delete(file);
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException) { }
        }
    }

    private string Begin()
    {
        if (_replaces)
        {
            _replacement = FolderReplacement.Begin(_folder);
            return _replacement.Folder;
        }

        Directory.CreateDirectory(_folder);
        if (UnfinishedMark.CommandIn(_folder) is null)
        {
            UnfinishedMark.Write(_folder, _command);
        }

        foreach (string session in Directory.GetDirectories(_folder))
        {
            // Taking the lock also deletes that of a stopped command.
            using FolderLock held = FolderLock.Take(session);
            SessionFolder.Clear(session);
            UnfinishedMark.Delete(session);
            Directory.Delete(session);
        }

        return _folder;
    }

    /// <summary>Whether an entry of the folder is a numbered session or a sign of the command that wrote it.</summary>
    private static bool IsOwn(string entry)
    {
        string name = Path.GetFileName(entry);
        return Directory.Exists(entry)
            ? Number().IsMatch(name) && new FileInfo(entry).LinkTarget is null && SessionFolder.ForeignIn(entry) is null
            : UnfinishedMark.Is(name) || Lock().IsMatch(name);
    }

    [GeneratedRegex(@"\A[0-9]{4,}\z", RegexOptions.CultureInvariant)]
    private static partial Regex Number();

    [GeneratedRegex(@"\A\.[0-9]{4,}\.harvester-lock", RegexOptions.CultureInvariant)]
    private static partial Regex Lock();
}
