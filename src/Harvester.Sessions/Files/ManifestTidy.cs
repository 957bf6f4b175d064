using System.Text;

namespace Harvester.Sessions.Files;

/// <summary>
/// Rewrites a manifest that was appended to while a session was recorded: frames in order, then the other files by their paths. The same
/// session has the same manifest then, however it came about.
/// </summary>
public static class ManifestTidy
{
    private static readonly UTF8Encoding Utf8 = new(encoderShouldEmitUTF8Identifier: false);

    /// <summary>Rewrites the manifest in a folder; the old one is whole until the new one is.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="isFrame">Says by its number whether a frame is part of the session; the lines of others are left out.</param>
    /// <param name="keepsReplaced">Whether lines of files that were replaced since stay too.</param>
    /// <param name="isDurable">Whether the manifest is on the disk when this returns.</param>
    /// <exception cref="IOException">The manifest cannot be read or written.</exception>
    /// <exception cref="UnauthorizedAccessException">The manifest cannot be read or written.</exception>
    public static void Run(string folder, Predicate<int> isFrame, bool keepsReplaced, bool isDurable)
    {
        string path = Path.Combine(folder, Manifest.FileName);
        AtomicFile.Write(path, stream => Copy(path, stream, isFrame, keepsReplaced), isDurable);
    }

    /// <summary>The lines of files that belong to no single frame, in the order in which they stand at the end of a manifest.</summary>
    /// <param name="lines">The lines in the order in which they were written.</param>
    /// <param name="keepsReplaced">Whether lines of files that were replaced since stay too.</param>
    internal static IEnumerable<string> InOrder(IEnumerable<string> lines, bool keepsReplaced) =>
        lines
            .GroupBy(Manifest.PathOf, StringComparer.Ordinal)
            .OrderBy(file => file.Key, StringComparer.Ordinal)
            .SelectMany(file => keepsReplaced ? file.Distinct() : [file.Last()]);

    private static void Copy(string from, Stream to, Predicate<int> isFrame, bool keepsReplaced)
    {
        using var writer = new StreamWriter(to, Utf8, 1 << 16, leaveOpen: true) { NewLine = "\n" };
        var others = new List<string>();
        using (var reader = new StreamReader(RegularFile.OpenRead(from), Utf8))
        {
            while (reader.ReadLine() is { } line)
            {
                if (!Manifest.IsIntact(line))
                {
                    continue;
                }

                if (Manifest.FrameOf(line) is not { } frame)
                {
                    others.Add(line);
                }
                else if (isFrame(frame))
                {
                    writer.WriteLine(line);
                }
            }
        }

        foreach (string line in InOrder(others, keepsReplaced))
        {
            writer.WriteLine(line);
        }
    }
}
