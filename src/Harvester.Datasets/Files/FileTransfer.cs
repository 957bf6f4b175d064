using System.IO;
using Harvester.Sessions.Files;

namespace Harvester.Datasets.Files;

/// <summary>Transfers a file between datasets, atomically.</summary>
internal static class FileTransfer
{
    /// <summary>Links a file, or copies it if requested or if linking is not possible. An existing file is replaced.</summary>
    /// <exception cref="DatasetFormatException">The source does not exist.</exception>
    /// <exception cref="IOException">It cannot be read, or the target not be written or closed.</exception>
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
                AtomicFile.Fill(temporary, stream => Copy(source, stream), isDurable: false);
            }
        });
    }

    private static void Copy(string source, Stream target)
    {
        using FileStream file = InputFile.OpenRead(source);
        file.CopyTo(target);
    }
}
