using Harvester.Datasets.Derivation;
using Harvester.Datasets.Files;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Outputs;

/// <summary>
/// The folder to which a command writes a session. A new session is written in place, with a mark until it is complete, so that the same
/// command recognises its own unfinished result. A session to be replaced stays as it is until the new one, written beside it, is complete.
/// </summary>
public sealed class SessionOutput : IDisposable
{
    private readonly Action<string> _warn;
    private readonly string _folder;
    private readonly string _command;
    private readonly FolderLock _held;
    private readonly bool _replaces;
    private readonly bool _keepsFrames;
    private readonly bool _resumes;
    private FolderReplacement? _replacement;
    private bool _isBegun;
    private bool _isComplete;
    private bool _isStopped;

    /// <summary>Locks the folder and checks it.</summary>
    /// <param name="warn">Receives warnings, one line each.</param>
    /// <param name="folder">The folder.</param>
    /// <param name="command">The command, as its mark names it.</param>
    /// <param name="overwrite">Whether a session there is to be replaced; null for a command that never replaces one.</param>
    /// <param name="keepsFrames">Whether a new session that was begun stays when the command fails, because its frames are valid.</param>
    /// <param name="resumes">Whether to continue what the same command left unfinished, instead of starting from the beginning.</param>
    /// <param name="option">The option that names the folder.</param>
    /// <param name="minFreeBytes">Space that is to stay free on its disk, bytes; 0 watches nothing.</param>
    /// <exception cref="IOException">The folder cannot be written.</exception>
    /// <exception cref="Harvester.Sessions.Files.LowSpaceException">Less space is free than is to stay free.</exception>
    /// <exception cref="OccupiedFolderException">The folder is in use, or holds something that is not to be replaced.</exception>
    public SessionOutput(
        Action<string> warn,
        string folder,
        string command,
        bool? overwrite,
        bool keepsFrames = false,
        bool resumes = false,
        string option = "--out",
        long minFreeBytes = 0
    )
    {
        _warn = warn;
        _folder = folder;
        _command = command;
        _keepsFrames = keepsFrames;
        _resumes = resumes;
        _held = FolderLock.Take(folder);
        try
        {
            _replaces = OutputFolder.Check(folder, command, overwrite, option);
            OutputDisk.Check(folder, option, minFreeBytes);
        }
        catch
        {
            _held.Dispose();
            throw;
        }
    }

    /// <summary>Whether an earlier session stays unless the command succeeds.</summary>
    public bool KeepsFormer => _replaces;

    /// <summary>
    /// Makes room, and returns the folder to write to, which is empty except for its mark and, where the command resumes, its own frames.
    /// </summary>
    /// <exception cref="IOException">The folder cannot be made or cleared.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder may not be made or cleared.</exception>
    public string Begin()
    {
        if (_replaces)
        {
            _replacement = FolderReplacement.Begin(_folder);
            return _replacement.Folder;
        }

        Directory.CreateDirectory(_folder);
        _isBegun = true;
        if (UnfinishedMark.CommandIn(_folder) is null)
        {
            UnfinishedMark.Write(_folder, _command);
        }

        if (!_resumes)
        {
            SessionFolder.Clear(_folder);
        }

        return _folder;
    }

    /// <summary>
    /// Writes the session. If that is stopped by a signal or by the disk, what was written stays for the same command with --resume.
    /// </summary>
    /// <typeparam name="T">The type of the result.</typeparam>
    /// <param name="write">Writes to the folder that <see cref="Begin"/> gave.</param>
    public T Writing<T>(Func<T> write)
    {
        try
        {
            return write();
        }
        catch (Exception e) when (e is OperationCanceledException or IOException or UnauthorizedAccessException)
        {
            _isStopped = true;
            throw;
        }
    }

    /// <summary>Makes the session that was written the one in the folder.</summary>
    /// <exception cref="IOException">That is impossible; a session to be replaced is as it was.</exception>
    /// <exception cref="UnauthorizedAccessException">That is impossible; a session to be replaced is as it was.</exception>
    public void Complete()
    {
        if (_replacement is null)
        {
            SessionFolder.DeleteJournal(_folder);
            UnfinishedMark.Delete(_folder);
        }
        else if (_replacement.Complete() is { } former)
        {
            _warn($"The former session is replaced, but its files in '{former}' cannot be deleted. Delete them yourself.");
        }

        _isComplete = true;
    }

    /// <summary>Deletes an unfinished session that cannot be used, and releases the folder.</summary>
    public void Dispose()
    {
        _replacement?.Dispose();
        if (_isBegun && !_isComplete && !IsKept())
        {
            Discard();
        }

        _held.Dispose();
    }

    private bool IsKept() =>
        (_keepsFrames && File.Exists(Path.Combine(_folder, SessionInfo.FileName))) || (_isStopped && SessionFolder.HasJournal(_folder));

    private void Discard()
    {
        try
        {
            SessionFolder.Clear(_folder);
            UnfinishedMark.Delete(_folder);
            Directory.Delete(_folder);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The same command clears it when it is given again; a folder with something else stays.
            return;
        }
    }
}
