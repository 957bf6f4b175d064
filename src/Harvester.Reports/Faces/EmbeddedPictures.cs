using Harvester.Sessions.Reading.Files;

namespace Harvester.Reports.Faces;

/// <summary>Reads the images to embed in a page. Each must lie in its folder, and their total size is limited.</summary>
internal sealed class EmbeddedPictures
{
    /// <summary>An uncompressed image of 4096 x 4096 pixels has 50 MB.</summary>
    private const int MaxPictureBytes = 64 << 20;

    /// <summary>Browsers do not show larger pages.</summary>
    private const long MaxBytes = 512 << 20;

    private long _bytes;

    /// <summary>Reads an image.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="name">Path of the image within the folder.</param>
    /// <exception cref="DatasetFormatException">The image lies outside the folder, or is too large.</exception>
    public byte[] Read(string folder, string name)
    {
        byte[] picture = InputFile.ReadAllBytes(InnerPath.Of(folder, name), MaxPictureBytes);
        _bytes += picture.Length;
        return _bytes <= MaxBytes
            ? picture
            : throw new DatasetFormatException(
                FormattableString.Invariant(
                    $"'{folder}': the images have more than {MaxBytes >> 20} MiB in all. Make them smaller, or split the table."
                )
            );
    }
}
