using System.IO.Compression;
using System.Text;
using Harvester.Capture.SelfTests;
using Harvester.Sessions.Files;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.SelfTests;

namespace Harvester.Play.SelfTests;

/// <summary>The zip of a self-test: selftest.json and the pictures.</summary>
internal static class SelfTestArchive
{
    /// <summary>The time of every entry, so that the bytes depend on nothing else than the content.</summary>
    private static readonly DateTimeOffset Time = new(2000, 1, 1, 0, 0, 0, TimeSpan.Zero);

    /// <summary>Writes the zip, whole or not at all.</summary>
    /// <param name="path">The file; its folder is created.</param>
    /// <param name="json">The text of selftest.json.</param>
    /// <param name="test">A self-test that is over.</param>
    public static void Write(string path, string json, SelfTest test)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
        AtomicFile.Write(
            path,
            stream =>
            {
                using var zip = new ZipArchive(stream, ZipArchiveMode.Create, leaveOpen: true);
                using (Stream entry = Entry(zip, SelfTestJson.FileName))
                {
                    byte[] text = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false).GetBytes(json);
                    entry.Write(text, 0, text.Length);
                }

                var encoder = new PngEncoder();
                foreach (SelfTestPicture picture in test.Pictures)
                {
                    using Stream entry = Entry(zip, picture.Name + ".png");
                    encoder.Write(picture.Picture, entry);
                }
            }
        );
    }

    private static Stream Entry(ZipArchive zip, string name)
    {
        ZipArchiveEntry entry = zip.CreateEntry(name, CompressionLevel.Fastest);
        entry.LastWriteTime = Time;
        return entry.Open();
    }
}
