using System;
using System.IO;
using System.Linq;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;

/// <summary>Encodes the picture of make.py with the mod and compares the files with libjpeg's.</summary>
internal static class OnMono
{
    private static int Main(string[] args)
    {
        var picture = new PixelBuffer(new ImageSize(45, 29));
        for (int y = 0, at = 0; y < 29; y++)
        {
            for (int x = 0; x < 45; x++)
            {
                picture.Bytes[at++] = (byte)((x * 11) + (y * 7));
                picture.Bytes[at++] = (byte)((x * x * 3) + y);
                picture.Bytes[at++] = (byte)(x ^ (y * 5));
            }
        }

        int wrong = 0;
        foreach (int quality in new[] { 50, 95, 100 })
        {
            var stream = new MemoryStream();
            new JpegEncoder(quality).Write(picture, stream);
            bool same = stream.ToArray().SequenceEqual(File.ReadAllBytes(Path.Combine(args[0], "quality-" + quality + ".jpg")));
            Console.WriteLine("quality " + quality + ": " + (same ? "the bytes of libjpeg" : "OTHER BYTES"));
            wrong += same ? 0 : 1;
        }

        return wrong;
    }
}
