using System.Globalization;
using System.Runtime.InteropServices;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Formats.Video;

/// <summary>
/// Encodes images as a video of a constant rate, in which image k is frame k. The images are decoded here, and reach ffmpeg as plain
/// pixels: its own decoders of JPEG give other pixels than libjpeg's.
/// </summary>
internal static class VideoEncoder
{
    /// <summary>Threads are given, because the bytes of H.264 depend on their number.</summary>
    private const string Threads = "4";

    /// <summary>Every tenth frame stands for itself, so that a reader that jumps decodes nine frames at most.</summary>
    private const string KeyFrames = "10";

    private static readonly string[] H264 =
    [
        "-vf",
        "scale=out_color_matrix=bt709:out_range=tv",
        "-c:v",
        "libx264",
        "-preset",
        "veryfast",
        "-crf",
        "18",
        "-bf",
        "0",
        "-g",
        KeyFrames,
        "-colorspace",
        "bt709",
        "-color_primaries",
        "bt709",
        "-color_trc",
        "bt709",
        "-movflags",
        "+faststart",
        "-f",
        "mp4",
    ];

    private static readonly string[] Ffv1 = ["-c:v", "ffv1", "-level", "3", "-g", "1", "-slices", "4", "-slicecrc", "1", "-f", "matroska"];

    /// <summary>Encodes colour images.</summary>
    /// <param name="target">File to write.</param>
    /// <param name="images">Paths of the images.</param>
    /// <param name="rate">Frames per second.</param>
    /// <param name="isLossless">Whether the pixels stay exactly as they are.</param>
    /// <exception cref="DatasetFormatException">An image is damaged or of another size than the first.</exception>
    /// <exception cref="IOException">ffmpeg failed.</exception>
    public static void WriteColours(string target, IEnumerable<string> images, string rate, bool isLossless)
    {
        IEnumerable<PixelBuffer> pictures = ReadAhead.Select(images, PictureReader.Read);
        Encode(
            target,
            pictures.Select(picture => (picture.Size, (ReadOnlyMemory<byte>)picture.Bytes)),
            rate,
            "rgb24",
            size =>
                isLossless
                    ? ["-pix_fmt", "bgr0", .. Ffv1]
                    // Colours of half the resolution need even sides.
                    : [.. H264[..2], "-pix_fmt", size.Width % 2 + size.Height % 2 == 0 ? "yuv420p" : "yuv444p", .. H264[2..]]
        );
    }

    /// <summary>Encodes maps of 16 bits, without loss.</summary>
    /// <param name="target">File to write.</param>
    /// <param name="maps">Paths of the maps.</param>
    /// <param name="rate">Frames per second.</param>
    /// <exception cref="DatasetFormatException">A map is damaged or of another size than the first.</exception>
    /// <exception cref="IOException">ffmpeg failed.</exception>
    public static void WriteMaps(string target, IEnumerable<string> maps, string rate)
    {
        IEnumerable<InstanceMap> read = ReadAhead.Select(maps, PngDecoder.ReadInstanceMap);
        Encode(
            target,
            read.Select(map => (map.Image, (ReadOnlyMemory<byte>)MemoryMarshal.AsBytes(map.Ids.AsSpan()).ToArray())),
            rate,
            BitConverter.IsLittleEndian ? "gray16le" : "gray16be",
            _ => ["-pix_fmt", "gray16le", .. Ffv1]
        );
    }

    private static void Encode(
        string target,
        IEnumerable<(ImageSize Size, ReadOnlyMemory<byte> Bytes)> pictures,
        string rate,
        string pixels,
        Func<ImageSize, string[]> codec
    )
    {
        using IEnumerator<(ImageSize Size, ReadOnlyMemory<byte> Bytes)> next = pictures.GetEnumerator();
        if (!next.MoveNext())
        {
            throw new DatasetFormatException("A sequence has no images. Delete the folder, and export again.");
        }

        ImageSize size = next.Current.Size;
        string sides = string.Create(CultureInfo.InvariantCulture, $"{size.Width}x{size.Height}");
        FfmpegProgram.Run(
            [
                "-hide_banner",
                "-loglevel",
                "error",
                "-y",
                "-f",
                "rawvideo",
                "-pixel_format",
                pixels,
                "-video_size",
                sides,
                "-framerate",
                rate,
                "-i",
                "pipe:0",
                "-map_metadata",
                "-1",
                "-fflags",
                "+bitexact",
                "-flags:v",
                "+bitexact",
                "-threads",
                Threads,
                .. codec(size),
                target,
            ],
            stream =>
            {
                do
                {
                    if (next.Current.Size != size)
                    {
                        throw new DatasetFormatException(
                            $"An image is {next.Current.Size.Width} x {next.Current.Size.Height} pixels, and the first of its sequence "
                                + $"{sides}; a video has one size. Export the sessions separately."
                        );
                    }

                    stream.Write(next.Current.Bytes.Span);
                } while (next.MoveNext());
            }
        );
    }
}
