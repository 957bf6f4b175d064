using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Reports.Sessions;

/// <summary>
/// Turns the pictures of a session into JPEG files for a report, all by the same scale, several at a time. A JPEG file at full size and a
/// file that cannot be decoded stay as they are.
/// </summary>
/// <param name="scale">Sides of the pictures in the report by those in the session; greater than 0, at most 1.</param>
internal sealed class PictureEmbedder(double scale)
{
    /// <summary>Text, lamps and plates stay legible at half the bytes of a session's JPEG files.</summary>
    private const int Quality = 80;

    /// <summary>Pictures that are encoded to find the scale.</summary>
    private const int Samples = 8;

    private const int ScaleSteps = 16;
    private const int SmallestStep = 2;

    /// <summary>Scale of the pictures, as a share of their sides.</summary>
    public double Scale => scale;

    /// <summary>The greatest scale, in sixteenths from 1 to 1/8, at which pictures need no more than a number of bytes.</summary>
    /// <param name="paths">The pictures.</param>
    /// <param name="maxBytes">Bytes of their files together, at most.</param>
    /// <returns>The embedder, and how many of the pictures fit in at its scale: at least 1.</returns>
    public static (PictureEmbedder Embedder, int Count) Fitting(IReadOnlyList<string> paths, long maxBytes)
    {
        string[] samples = [.. EvenSelection.Of(paths.Count, Samples).Select(index => paths[index])];
        for (int step = ScaleSteps; ; step--)
        {
            var embedder = new PictureEmbedder(step / (double)ScaleSteps);
            double mean = embedder.Embed(samples).Average(picture => (double)picture.Bytes.Length);
            if (mean * paths.Count <= maxBytes || step == SmallestStep)
            {
                return (embedder, (int)Math.Clamp(maxBytes / mean, 1, paths.Count));
            }
        }
    }

    /// <summary>The pictures in their order; a few are made ahead.</summary>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public IEnumerable<EmbeddedPicture> Embed(IEnumerable<string> paths) => ReadAhead.Select(paths, Embed);

    private EmbeddedPicture Embed(string path)
    {
        string type = TypeOf(path);
        if (scale < 1 || type != ImageHeader.Jpeg)
        {
            try
            {
                return new EmbeddedPicture(ImageHeader.Jpeg, Encoded(PictureReader.Read(path)));
            }
            catch (DatasetFormatException)
            {
                // The report shows what there is; validate finds what is damaged.
            }
        }

        return new EmbeddedPicture(type, InputFile.ReadAllBytes(path, InputFile.MaxPictureBytes));
    }

    private static string TypeOf(string path)
    {
        try
        {
            return ImageHeader.Read(path).MediaType;
        }
        catch (DatasetFormatException e)
        {
            throw new DatasetFormatException($"{path} cannot be shown: {e.Message}", e);
        }
    }

    private byte[] Encoded(PixelBuffer picture)
    {
        PixelBuffer shown = picture;
        if (scale < 1)
        {
            var size = new ImageSize(Scaled(picture.Size.Width), Scaled(picture.Size.Height));
            shown = new PixelBuffer(size);
            new ImageScaler(picture.Size, size).Scale(picture, shown);
        }

        using var file = new MemoryStream();
        new JpegEncoder(Quality).Write(shown, file);
        return file.ToArray();
    }

    private int Scaled(int side) => Math.Max(1, (int)Math.Round(side * scale));
}
