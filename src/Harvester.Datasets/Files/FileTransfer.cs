using System.IO;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Files;

/// <summary>Brings a file from one dataset into another, whole or not at all.</summary>
internal static class FileTransfer
{
    /// <summary>
    /// Gives a file a second name, or copies it where that is asked for or cannot be helped. A file of that name is replaced.
    /// </summary>
    /// <exception cref="DatasetFormatException">There is no such file.</exception>
    public static void Place(string target, string source, ImageTransfer transfer)
    {
        if (!File.Exists(source))
        {
            throw new DatasetFormatException($"'{source}' is missing.");
        }

        AtomicFile.Make(target, temporary =>
        {
            if (transfer == ImageTransfer.Copy || !HardLink.TryCreate(temporary, source))
            {
                File.Copy(source, temporary);
            }
        });
    }
}
