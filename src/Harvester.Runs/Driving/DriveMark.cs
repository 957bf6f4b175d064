using Harvester.Runs.Evaluation.Scores;
using Harvester.Sessions.Files;

namespace Harvester.Runs.Driving;

/// <summary>
/// The drive that belongs to an unfinished recording: the mark of the recording has the digest of its drive.json. A command that is given
/// again thus knows the drive that it had written, and replaces no other.
/// </summary>
/// <param name="recording">The folder of the recording.</param>
/// <param name="command">The command that records, as in the mark.</param>
/// <param name="output">The folder of the drive.</param>
public sealed class DriveMark(string recording, string command, string output)
{
    private readonly string _file = Path.Combine(output, DriveRecord.FileName);

    private bool IsMarked => UnfinishedMark.CommandIn(recording) == command;

    /// <summary>Whether the drive in the folder is the one that this command had written when it was stopped.</summary>
    /// <exception cref="IOException">A file cannot be read.</exception>
    /// <exception cref="UnauthorizedAccessException">A file cannot be read.</exception>
    public bool IsThere() => IsMarked && DigestThere() is { } there && UnfinishedMark.NotesIn(recording).Contains(there);

    /// <summary>
    /// Notes the drive that is written next, beside the one that it replaces. That a recording cannot be marked is no fault: given again,
    /// the command asks for --overwrite.
    /// </summary>
    /// <param name="record">The bytes of drive.json.</param>
    public void Note(byte[] record)
    {
        try
        {
            if (IsMarked)
            {
                string[] former = IsThere() ? [DigestThere()!] : [];
                UnfinishedMark.Write(recording, command, [.. former.Append(FileDigest.Of(record, record.Length).Sha256).Distinct()]);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return;
        }
    }

    private string? DigestThere() => File.Exists(_file) ? FileDigest.OfFile(_file).Sha256 : null;
}
