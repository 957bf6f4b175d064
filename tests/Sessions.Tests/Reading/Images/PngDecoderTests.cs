using System.Buffers.Binary;
using System.IO.Compression;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Sessions.Tests.Reading.Images;

public sealed class PngDecoderTests : IDisposable
{
    private readonly string _path = Path.GetTempFileName();

    public void Dispose() => File.Delete(_path);

    [Fact]
    public void ReadRgb_reads_back_what_the_encoder_wrote()
    {
        var picture = new PixelBuffer(new ImageSize(37, 23));
        new Random(5).NextBytes(picture.Bytes);
        using (FileStream file = File.Create(_path))
        {
            new PngEncoder().Write(picture, file);
        }

        PixelBuffer read = PngDecoder.ReadRgb(_path);

        Assert.Equal(picture.Size, read.Size);
        Assert.Equal(picture.Bytes, read.Bytes);
    }

    [Fact]
    public void ReadInstanceMap_reads_back_what_the_encoder_wrote()
    {
        var map = new InstanceMap(new ImageSize(37, 23));
        var random = new Random(6);
        for (int i = 0; i < map.Ids.Length; i++)
        {
            map.Ids[i] = (ushort)random.Next(ushort.MaxValue + 1);
        }

        using (FileStream file = File.Create(_path))
        {
            new PngEncoder().Write(map, file);
        }

        InstanceMap read = PngDecoder.ReadInstanceMap(_path);

        Assert.Equal(map.Image, read.Image);
        Assert.Equal(map.Ids, read.Ids);
    }

    [Fact]
    public void ReadInstanceMap_of_a_colour_picture_names_the_expected_kind()
    {
        File.WriteAllBytes(_path, TestImages.Png(2, 2));

        Assert.Contains(
            "16-bit grey",
            Assert.Throws<DatasetFormatException>(() => PngDecoder.ReadInstanceMap(_path)).Message,
            StringComparison.Ordinal
        );
    }

    [Theory]
    [InlineData(0, new byte[] { 1, 2, 3, 4, 5, 6 })]
    // Left: 1 2 3, then 4+1 5+2 6+3.
    [InlineData(1, new byte[] { 1, 2, 3, 5, 7, 9 })]
    // Above is 10 20 30 40 50 60.
    [InlineData(2, new byte[] { 11, 22, 33, 44, 55, 66 })]
    // Half of left and above: 1+5 2+10 3+15, then 4+(6+40)/2 5+(12+50)/2 6+(18+60)/2.
    [InlineData(3, new byte[] { 6, 12, 18, 27, 36, 45 })]
    // Paeth of left 0 and above 10, upper left 0 takes above; then left 11, above 40, upper left 10: estimate 41 is nearest to 40.
    [InlineData(4, new byte[] { 11, 22, 33, 44, 55, 66 })]
    public void ReadRgb_undoes_each_filter(byte filter, byte[] secondRow)
    {
        WritePng([0, 10, 20, 30, 40, 50, 60, filter, 1, 2, 3, 4, 5, 6]);

        Assert.Equal([10, 20, 30, 40, 50, 60, .. secondRow], PngDecoder.ReadRgb(_path).Bytes);
    }

    [Theory]
    [InlineData(new byte[] { 0, 1, 2 })]
    [InlineData(new byte[] { 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 })]
    public void ReadRgb_reports_damaged_rows(byte[] rows)
    {
        WritePng(rows);

        Assert.Contains(
            "damaged",
            Assert.Throws<DatasetFormatException>(() => PngDecoder.ReadRgb(_path)).Message,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void ReadRgb_never_reads_other_pixels_for_a_flipped_bit()
    {
        var picture = new PixelBuffer(new ImageSize(13, 7));
        new Random(6).NextBytes(picture.Bytes);
        using (FileStream file = File.Create(_path))
        {
            new PngEncoder().Write(picture, file);
        }

        byte[] whole = File.ReadAllBytes(_path);
        int refused = 0;
        for (int bit = 0; bit < 8 * whole.Length; bit++)
        {
            byte[] damaged = [.. whole];
            damaged[bit / 8] ^= (byte)(1 << (bit % 8));
            File.WriteAllBytes(_path, damaged);
            try
            {
                Assert.Equal(picture.Bytes, PngDecoder.ReadRgb(_path).Bytes);
            }
            catch (DatasetFormatException)
            {
                refused++;
            }
        }

        // Only the checksums of the chunks after the header, and the bytes of the end chunk, are not needed for the pixels.
        Assert.InRange(refused, 8 * (whole.Length - 24), 8 * whole.Length);
    }

    [Fact]
    public void ReadRgb_of_a_grey_picture_names_the_expected_kind()
    {
        File.WriteAllBytes(_path, TestImages.Png(2, 2, bitDepth: 16, colourType: 0));

        Assert.Contains(
            "8-bit colour",
            Assert.Throws<DatasetFormatException>(() => PngDecoder.ReadRgb(_path)).Message,
            StringComparison.Ordinal
        );
    }

    private void WritePng(byte[] rows)
    {
        byte[] empty = TestImages.PngWithoutPixels(2, 2);
        const int endChunkLength = 12;
        using var compressed = new MemoryStream();
        using (var zlib = new ZLibStream(compressed, CompressionLevel.Optimal, leaveOpen: true))
        {
            zlib.Write(rows);
        }

        byte[] length = new byte[4];
        BinaryPrimitives.WriteInt32BigEndian(length, (int)compressed.Length);
        File.WriteAllBytes(
            _path,
            [.. empty[..^endChunkLength], .. length, .. "IDAT"u8, .. compressed.ToArray(), 0, 0, 0, 0, .. empty[^endChunkLength..]]
        );
    }
}
