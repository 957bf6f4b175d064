using BenchmarkDotNet.Attributes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;

namespace Harvester.Benchmarks;

/// <summary>
/// How long an image of 800 x 600 takes to be written in each format: slopes of colour with noise, by a standard deviation of 0 (a clear
/// sky) and of 5 (foliage).
/// </summary>
public class ImageBenchmarks
{
    private readonly PixelBuffer _picture = new(new ImageSize(800, 600));
    private PictureEncoder _encoder = null!;

    [Params(ImageFormat.Png, ImageFormat.Bmp, ImageFormat.Jpeg)]
    public ImageFormat Format { get; set; }

    [Params(0, 5)]
    public double Noise { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        var random = new Random(1);
        _encoder = new PictureEncoder(Format);
        for (int i = 0; i < _picture.Bytes.Length; i++)
        {
            int pixel = i / PixelBuffer.BytesPerPixel;
            double slope = (pixel % 800 / 5.0) + (pixel / 800 / 10.0) + (20 * (i % PixelBuffer.BytesPerPixel));
            double normal = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
            _picture.Bytes[i] = (byte)Math.Clamp(slope + (Noise * normal), 0, 255);
        }
    }

    [Benchmark]
    public long Write()
    {
        using var file = new MemoryStream(2_000_000);
        _encoder.Write(_picture, file);
        return file.Length;
    }
}
