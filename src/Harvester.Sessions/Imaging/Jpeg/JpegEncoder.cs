using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>
/// Writes baseline JPEG images (ITU-T T.81) in a JFIF file: YCbCr without chroma subsampling, so that small lights keep their colours, and
/// the Huffman tables of the standard's annex K. All arithmetic is in integers and follows the accurate ("islow") method of libjpeg: every
/// runtime writes the same bytes, and they equal those of libjpeg at the same quality. One encoder serves one thread; its buffers are
/// reused.
/// </summary>
public sealed class JpegEncoder
{
    /// <summary>The minimum quality: the coarsest quantisation.</summary>
    public const int MinQuality = 1;

    /// <summary>The maximum quality: all divisors are 1.</summary>
    public const int MaxQuality = 100;

    /// <summary>The default quality: errors are hardly visible, at about a third of the size of a PNG.</summary>
    public const int DefaultQuality = 95;

    private readonly JpegHeader _header;
    private readonly BlockTransform _transform;
    private readonly EntropyWriter _scan = new();
    private readonly QuantisedBlocks _blocks = new();

    /// <summary>Creates an encoder.</summary>
    /// <param name="quality">1 to 100, on the scale of libjpeg.</param>
    /// <exception cref="ArgumentOutOfRangeException">The quality is out of its range.</exception>
    public JpegEncoder(int quality = DefaultQuality)
        : this(quality, BlockTransform.Fastest) { }

    internal JpegEncoder(int quality, Func<QuantisationTable, QuantisationTable, BlockTransform> transform)
    {
        if (quality is < MinQuality or > MaxQuality)
        {
            throw new ArgumentOutOfRangeException(
                nameof(quality),
                quality,
                $"The quality of a JPEG picture is {MinQuality} to {MaxQuality}."
            );
        }

        QuantisationTable luma = QuantisationTable.Luma(quality);
        QuantisationTable chroma = QuantisationTable.Chroma(quality);
        _header = new JpegHeader(luma, chroma);
        _transform = transform(luma, chroma);
    }

    /// <summary>Writes an image as a complete baseline JPEG file.</summary>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    public void Write(PixelBuffer picture, Stream target)
    {
        if (picture is null)
        {
            throw new ArgumentNullException(nameof(picture));
        }

        if (target is null)
        {
            throw new ArgumentNullException(nameof(target));
        }

        ImageSize size = picture.Size;
        _header.Write(size, target);
        _scan.Begin();
        for (int row = 0; row < size.Height; row += JpegBlock.Side)
        {
            for (int column = 0; column < size.Width; column += JpegBlock.Side)
            {
                _transform.Transform(picture, column, row, _blocks);
                for (int component = 0; component < JpegBlock.Components; component++)
                {
                    _scan.Write(_blocks, component);
                }
            }
        }

        _scan.End(target);
        JpegHeader.WriteEnd(target);
    }
}
