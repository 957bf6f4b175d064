namespace Harvester.Sessions.Files;

/// <summary>Another process writes to the folder. The message says which, since when, and what to do.</summary>
public sealed class FolderLockedException : IOException
{
    /// <summary>Makes the exception with a message for people.</summary>
    public FolderLockedException(string message)
        : base(message) { }
}
