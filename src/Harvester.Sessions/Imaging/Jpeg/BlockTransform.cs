using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>Transforms blocks of pixels into quantised coefficients: conversion to YCbCr, cosine transform, division.</summary>
internal abstract class BlockTransform
{
    private const int RowBytes = JpegBlock.Side * PixelBuffer.BytesPerPixel;
    private readonly byte[] _border = new byte[JpegBlock.Side * RowBytes];

    /// <summary>The fastest transform on this machine; all give the same coefficients.</summary>
    public static BlockTransform Fastest(QuantisationTable luma, QuantisationTable chroma)
    {
#if NET
        if (System.Runtime.Intrinsics.X86.Avx2.IsSupported)
        {
            return new VectorBlockTransform(luma, chroma);
        }
#endif
        return new PortableBlockTransform(luma, chroma);
    }

    /// <summary>Transforms a block. Pixels beyond the image repeat those at its border.</summary>
    /// <param name="picture">The image.</param>
    /// <param name="column">Column of the block's first pixel.</param>
    /// <param name="row">Row of the block's first pixel.</param>
    /// <param name="blocks">Receives the result.</param>
    public void Transform(PixelBuffer picture, int column, int row, QuantisedBlocks blocks)
    {
        ImageSize size = picture.Size;
        if (column + JpegBlock.Side <= size.Width && row + JpegBlock.Side <= size.Height)
        {
            Transform(
                picture.Bytes,
                ((row * size.Width) + column) * PixelBuffer.BytesPerPixel,
                size.Width * PixelBuffer.BytesPerPixel,
                blocks
            );
            return;
        }

        CopyWithBorder(picture, column, row);
        Transform(_border, 0, RowBytes, blocks);
    }

    /// <summary>Transforms a block that lies completely in the image.</summary>
    /// <param name="pixels">Red, green and blue of each pixel.</param>
    /// <param name="start">Index of the block's first byte.</param>
    /// <param name="stride">Bytes from one row to the next.</param>
    /// <param name="blocks">Receives the result.</param>
    protected abstract void Transform(byte[] pixels, int start, int stride, QuantisedBlocks blocks);

    private void CopyWithBorder(PixelBuffer picture, int column, int row)
    {
        ImageSize size = picture.Size;
        int inside = Math.Min(JpegBlock.Side, size.Width - column);
        for (int y = 0; y < JpegBlock.Side; y++)
        {
            int from = ((Math.Min(row + y, size.Height - 1) * size.Width) + column) * PixelBuffer.BytesPerPixel;
            int to = y * RowBytes;
            Buffer.BlockCopy(picture.Bytes, from, _border, to, inside * PixelBuffer.BytesPerPixel);
            for (int x = inside; x < JpegBlock.Side; x++)
            {
                Buffer.BlockCopy(
                    picture.Bytes,
                    from + ((inside - 1) * PixelBuffer.BytesPerPixel),
                    _border,
                    to + (x * PixelBuffer.BytesPerPixel),
                    PixelBuffer.BytesPerPixel
                );
            }
        }
    }
}
