using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

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

        AtomicFile.Make(
            target,
            temporary =>
            {
                if (transfer == ImageTransfer.Copy || !HardLink.TryCreate(temporary, source))
                {
                    AtomicFile.Fill(temporary, stream => Copy(source, stream), isDurable: false);
                }
            }
        );
    }

    /// <summary>Whether a file has the bytes of a source already, and is not a link that leads elsewhere.</summary>
    /// <exception cref="IOException">One of them cannot be read.</exception>
    public static bool IsPlaced(string target, string source)
    {
        var file = new FileInfo(target);
        if (!file.Exists || file.LinkTarget is not null || !File.Exists(source) || file.Length != new FileInfo(source).Length)
        {
            return false;
        }

        return FileDigest.OfFile(target) == FileDigest.OfFile(source);
    }

    private static void Copy(string source, Stream target)
    {
        using FileStream file = InputFile.OpenRead(source);
        file.CopyTo(target);
    }
}
