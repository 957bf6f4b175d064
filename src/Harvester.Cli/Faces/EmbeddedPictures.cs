using System;
using Harvester.Datasets.Files;

namespace Harvester.Cli.Faces;

/// <summary>Pictures that a page holds: each lies in the folder that names it, and all together are not too large for a page.</summary>
internal sealed class EmbeddedPictures
{
    /// <summary>A photograph of 4096 x 4096 pixels, not compressed, has 50 MB.</summary>
    private const int MaxPictureBytes = 64 << 20;

    /// <summary>No browser shows a larger page.</summary>
    private const long MaxBytes = 512 << 20;

    private long _bytes;

    /// <summary>Reads a picture.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="name">Its path within it.</param>
    /// <exception cref="DatasetFormatException">It lies elsewhere, or is too large.</exception>
    public byte[] Read(string folder, string name)
    {
        byte[] picture = InputFile.ReadAllBytes(InnerPath.Of(folder, name), MaxPictureBytes);
        _bytes += picture.Length;
        return _bytes <= MaxBytes ? picture
            : throw new DatasetFormatException(FormattableString.Invariant($"'{folder}': the pictures together have more than {MaxBytes} bytes. Make them smaller, or split the table."));
    }
}
