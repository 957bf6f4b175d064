using System.IO;

namespace Harvester.Datasets.Files;

/// <summary>Brings a file from one dataset into another, under a temporary name first.</summary>
internal static class FileTransfer
{
    private const string Temporary = ".partial";

    /// <summary>Gives a file a second name, or copies it where that is asked for or cannot be helped. A file of that name is replaced.</summary>
    /// <exception cref="DatasetFormatException">There is no such file.</exception>
    public static void Place(string target, string source, ImageTransfer transfer)
    {
        if (!File.Exists(source))
        {
            throw new DatasetFormatException($"'{source}' is missing.");
        }

        File.Delete(target + Temporary);
        if (transfer == ImageTransfer.Copy || !HardLink.TryCreate(target + Temporary, source))
        {
            File.Copy(source, target + Temporary);
        }

        File.Delete(target);
        File.Move(target + Temporary, target);
    }
}
