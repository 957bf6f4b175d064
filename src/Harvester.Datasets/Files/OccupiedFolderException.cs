using System.IO;

namespace Harvester.Datasets.Files;

/// <summary>
/// The folder that output should go to holds something that is not to be replaced. The message says what, and what to do.
/// </summary>
public sealed class OccupiedFolderException : IOException
{
    /// <summary>Makes the exception with a message for people.</summary>
    public OccupiedFolderException(string message)
        : base(message)
    {
    }
}
