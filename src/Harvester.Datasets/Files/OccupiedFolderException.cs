namespace Harvester.Datasets.Files;

/// <summary>The output folder has files that must not be replaced. The message says which, and what to do.</summary>
public sealed class OccupiedFolderException : IOException
{
    /// <summary>Creates the exception with a message for the user.</summary>
    public OccupiedFolderException(string message)
        : base(message) { }
}
